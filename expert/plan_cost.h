#pragma once

#include <compare>
#include <vector>

#include "expert/execution_tree.h"
#include "scene/action.h"

namespace unietp {

/// What a plan takes. The lesser is the better plan: fewer steps, then a shorter way, then less that is disturbed.
struct PlanCost {
  int steps = 0;      // `stop` included, and one to set back each thing that the plan leaves open or on (tidying.h)
  int meters = 0;     // walked, rounded
  int disturbed = 0;  // things that the goal does not speak of and that the plan leaves elsewhere, open or on
  auto operator<=>(const PlanCost&) const = default;
};

/// Cost of a plan of one who is told everything, from the start; actions that fail cost nothing but their step.
PlanCost cost_of(ExecutionTree& executions, const std::vector<Action>& plan);

}  // namespace unietp
