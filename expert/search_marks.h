#pragma once

#include "expert/demonstration.h"
#include "expert/execution_tree.h"

namespace unietp {

/// Whether an action can be search: it moves the body or the camera, goes or turns to something, opens or closes.
bool may_be_search(ActionType type);

/// Marks the steps that only served to see something: those without which the rest, done in the same order by one who
/// has been told where everything is, reaches the goal as well. Each is left out alone. Those that are marked as
/// tidying (tidying.h) are not search.
void mark_search(ExecutionTree& executions, Demonstration& demonstration);

}  // namespace unietp
