#pragma once

#include <cstddef>
#include <vector>

#include "expert/execution_tree.h"
#include "scene/action.h"

namespace unietp {

/// A plan of one who is told everything (it ends with `stop`) as who looks ahead does it: where a thing is put down to
/// free the hand for others and fetched again, the others come first and the thing stays in the hand. Taken only where
/// the goal holds so, too, at less cost (plan_cost.h). The first `done` actions stay as they are.
std::vector<Action> without_parking(ExecutionTree& executions, std::vector<Action> plan, std::size_t done);

}  // namespace unietp
