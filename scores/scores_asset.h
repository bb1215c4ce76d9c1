#pragma once

#include <string_view>

namespace unietp {

/// A file of scores/assets/ that the build put into the program, by name. "" for any other.
std::string_view scores_asset(std::string_view name);

}  // namespace unietp
