#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// `pointer` inside the file `where`, as a URI fragment: "a.json#/nodes/3/size".
std::string at_pointer(std::string_view where, std::string_view pointer);
/// One token of a JSON pointer (RFC 6901), escaped.
std::string pointer_token(std::string_view name);

}  // namespace unietp
