#pragma once

#include <optional>
#include <vector>

#include "expert/demonstration.h"
#include "expert/execution_tree.h"
#include "generator/rejection.h"

namespace unietp {

/// A plan of somebody who forgets the order that a goal asks for, what has to stay, or how many are allowed: the
/// expert's for the goal without its constraints (logic/constraints.h) or with one of its orders reversed, of at most
/// as many steps as the demonstration in M1, `stop` included, without those that only tidy up. It does something, needs
/// each step for what it takes the goal for, and does not reach the goal. Empty when there is none: then the
/// constraints forbid nothing that anybody would do. Deterministic.
std::vector<Action> tempting_plan(const ExecutionTree& executions, const Demonstration& shown);

/// Stage: gives a demonstration in M1 that plan. Rejected as `not-tempting` if the goal has constraints and there is
/// none.
std::optional<Rejection> add_tempting_plan(Demonstration& demonstration, const ExecutionTree& executions);

}  // namespace unietp
