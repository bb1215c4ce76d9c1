#pragma once

#include "scene/action.h"

namespace unietp {

/// What each action takes, needs and changes, in the order of ActionType. From this table follow the symbolic world's
/// checks and changes of one object's states, what can be reached, the expert's direct actions, docs/action-table.md,
/// and in PDDL the actions on one object. What depends on a second object (where a thing is put, what a held tool does)
/// has only its needs here; its effects are code: symbolic/perform.cpp, and needs and effects in
/// pddl/domain_actions.cpp. simulation/ performs all actions in code of its own, and tests hold the three together.
std::span<const ActionInfo, kActionCount> action_table();

/// The rows of the failures, in the order of Failure.
std::span<const FailureInfo, kFailureCount> failure_table();

}  // namespace unietp
