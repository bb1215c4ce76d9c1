#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// A line of a goal as people read it, and how far it stands inside the lines above.
struct ProseLine {
  int depth = 0;
  std::string text;
  bool operator==(const ProseLine&) const = default;
};

/// A goal said word by word, as a logician reads it out: "for some mug a", "at the end: a is on b". Nothing is left out
/// or taken together, and no instruction's wording enters it, so that people can hold an instruction against it.
std::vector<ProseLine> goal_prose(const Formula& goal);

/// "HandTowel", "coffee_table.n.01": "hand towel", "coffee table".
std::string words_of_category(const std::string& category);

}  // namespace unietp
