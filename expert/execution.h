#pragma once

#include <vector>

#include "expert/expert.h"

namespace unietp {

/// Truth of the goal, by the direct evaluator, on the trace that the deltas make.
bool goal_holds(const Formula& goal, const Scene& start, const std::vector<Delta>& changes);

/// Does the actions from the start as an agent would live them.
Demonstration record(Rehearsal& rehearsal, const std::vector<Action>& actions);

/// Leaves out steps, as long as all that remain succeed and the goal still holds: single ones, then runs of up to
/// `longest_run` (a thing picked up and put back). `actions` ends with `stop`, which stays.
std::vector<Action> without_needless(Rehearsal& rehearsal, std::vector<Action> actions, std::size_t longest_run);

}  // namespace unietp
