#pragma once

#include <string_view>

namespace unietp {

/// The English that instructions are written in. Both are read.
enum class English { Us, Gb };

/// What people call what the knowledge base calls `name`, in singular: "stove", or "cooker" in Britain, for "oven
/// stove". "" where they call it so, too.
std::string_view everyday_name(std::string_view name, English english);

/// Whether a text may use a synonym of the knowledge base: false for what only a dictionary, a shop or the other
/// English says.
bool is_said(std::string_view synonym, English english);

}  // namespace unietp
