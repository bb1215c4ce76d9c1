#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// A line of a goal in words, and its indentation.
struct ProseLine {
  int depth = 0;
  std::string text;
  bool operator==(const ProseLine&) const = default;
};

/// A goal operator by operator, as a logician would read it out: "for some mug a", "at the end: a is on b". Nothing is
/// left out or summarized, and it shares no wording with instructions, so that people can compare the two.
std::vector<ProseLine> goal_prose(const Formula& goal);

/// "HandTowel", "coffee_table.n.01": "hand towel", "coffee table".
std::string words_of_category(const std::string& category);

}  // namespace unietp
