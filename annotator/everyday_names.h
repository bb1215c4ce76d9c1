#pragma once

#include <string_view>

namespace unietp {

/// The English that instructions are written in. Both are read.
enum class English { Us, Gb };

/// What people call what the knowledge base calls `name`, in singular: "stove", or "cooker" in Britain, for "oven
/// stove". "" where they call it so, too.
std::string_view everyday_name(std::string_view name, English english);

}  // namespace unietp
