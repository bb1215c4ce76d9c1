#pragma once

#include "scene/action.h"

namespace unietp {

/// What each action takes, needs and changes, in the order of ActionType. Everything without geometry follows from this
/// table: the symbolic actions, what can be reached, PDDL, the expert's direct actions, docs/action-table.md.
/// simulation/ performs the actions in code of its own, and a test holds the two together.
std::span<const ActionInfo, kActionCount> action_table();

/// The rows of the failures, in the order of Failure.
std::span<const FailureInfo, kFailureCount> failure_table();

}  // namespace unietp
