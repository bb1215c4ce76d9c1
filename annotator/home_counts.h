#pragma once

#include <string>
#include <vector>

#include "logic/evaluate.h"
#include "logic/formula.h"

namespace unietp {

/// How many things of a kind and description a home has at its start: whether a text says "the mug", "both mugs" or
/// "all the mugs".
class HomeCounts {
 public:
  HomeCounts() = default;  // of a home that is not known
  /// `start`: at its first position; outlives this.
  explicit HomeCounts(const Trace& start) : start_(&start) {}

  /// Whether there is a home to count in.
  bool is_known() const { return start_ != nullptr; }
  /// Empty also where it is not known, depends on another thing of the goal, or is what slicing makes.
  std::vector<EntityIndex> members(const Domain& domain, const std::string& variable) const;

 private:
  const Trace* start_ = nullptr;
};

/// The goal with a name in place of each variable over things of which the home has one: "for every red mug", "for
/// some red mug" and "the red mug" are the same there; and so are "two of two mugs" and "all the mugs". Equal in truth
/// on every trace of the home, whose kinds do not change.
Formula as_in_home(const Formula& goal, const HomeCounts& home);

/// The goal for a text about this home: what is asked of every one of one thing is asked of that thing, and what is
/// asked of N of N things of all of them. Denials and what holds over time stay as they are. `goal` is `expanded`.
Formula plainly_in_home(const Formula& goal, const HomeCounts& home);

/// The variables of the goal's outermost `exists` that only one of several things can stand for, since the others
/// already fulfill the goal: "wash the mug" where one of three is dirty. Sorted. Empty for a home that is not known.
std::vector<std::string> unique_variables(const Formula& goal, const HomeCounts& home);

}  // namespace unietp
