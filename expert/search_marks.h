#pragma once

#include <cstddef>

#include "expert/demonstration.h"
#include "expert/execution_tree.h"
#include "simulation/mode_rules.h"

namespace unietp {

/// Whether an action can be search: it moves the body or the camera, goes or turns to something, opens or closes.
bool may_be_search(ActionType type);

/// Of one who does a demonstration of so many steps again and has been told where everything is: the rules of M1, but
/// that no part of it is too long or fails too often.
ModeRules rules_with_full_knowledge(std::size_t steps);

/// Marks the steps that only served to see something: those without which the rest, done in the same order by one who
/// has been told where everything is, reaches the goal as well. Each is left out alone. Those that are marked as
/// tidying (tidying.h) are not search.
void mark_search(ExecutionTree& executions, Demonstration& demonstration);

}  // namespace unietp
