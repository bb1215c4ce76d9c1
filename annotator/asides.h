#pragma once

#include <span>
#include <string_view>

namespace unietp {

/// Sentences that give some background and demand nothing; none names a thing of a home.
std::span<const std::string_view> backgrounds();

/// What is said of a thing that the goal has nothing to do with: "Never mind" the bowl. Lower case.
std::span<const std::string_view> never_minds();

/// Openings of a long sentence with clauses inside clauses, before a command; words and commas with blanks between.
std::span<const std::string_view> nested_openings();

}  // namespace unietp
