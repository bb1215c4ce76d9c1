#pragma once

#include <span>
#include <string_view>

namespace unietp {

/// Background sentences without a request; none names an object of a home.
std::span<const std::string_view> backgrounds();

/// Openings of a remark on an object unrelated to the goal: "never mind" the bowl. Lower case.
std::span<const std::string_view> never_minds();

/// Openings of a long sentence with clauses inside clauses, before a command; words and commas with blanks between.
std::span<const std::string_view> nested_openings();

}  // namespace unietp
