#pragma once

#include <string>
#include <vector>

#include "core/rng.h"
#include "generator/specification.h"

namespace unietp::testing_support {

/// A goal that is one step off, and what the step is: "wrong object", "missing count", "swapped order", "extra demand",
/// "wrong referent", "missing part".
struct WrongGoal {
  std::string kind;
  Formula goal;
};

/// All the ways in which a text may miss this goal by one step. `others`: categories that may stand in for others.
std::vector<WrongGoal> wrong_goals(const Formula& goal, const std::vector<std::string>& others, Rng rng);

/// The same goal written otherwise: parts and neighboring quantifiers in another order, `not exists` for `forall not`
/// and the reverse, counts by another comparison, variables renamed.
Formula rewritten(const Formula& goal, Rng& rng);

}  // namespace unietp::testing_support
