#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// The plural of a noun as the language has it: "bookshelves", "loaves of bread", "women", "pairs of scissors"; of what
/// is plural or has no plural ("scissors", "series") the word itself. For names that no table gives a plural of.
std::string plural_of(std::string_view noun);

}  // namespace unietp
