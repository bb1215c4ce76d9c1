#pragma once

#include <cstddef>
#include <optional>

#include "symbolic/goal.h"

namespace unietp::testing {

/// The length of a shortest plan from the start, by an exhaustive best-first search over the symbolic actions; going to
/// a thing is a step that is taken only to act on it. nullopt when there is none shorter than `bound`, or more than
/// `most_worlds` would have to be looked at.
struct Optimum {
  std::optional<int> length;
  std::size_t worlds = 0;
  bool exhausted = false;  // all shorter plans were looked at
};
Optimum optimum(const symbolic::Setting& setting, const symbolic::World& start, const symbolic::Goal& goal, int bound,
                std::size_t most_worlds);

}  // namespace unietp::testing
