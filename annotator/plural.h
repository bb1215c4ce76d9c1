#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// The plural of an English noun: "bookshelves", "loaves of bread", "women", "pairs of scissors"; for
/// plurals and nouns without plural ("scissors", "series") the word itself. For names without a plural in the tables.
std::string plural_of(std::string_view noun);

}  // namespace unietp
