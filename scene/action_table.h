#pragma once

#include "scene/action.h"

namespace unietp {

/// What each action takes, needs and changes, in the order of ActionType. From this table follow the symbolic world,
/// what can be reached, the needs and effects of actions in PDDL, the expert's direct actions and docs/action-table.md.
/// What a change of place, slicing, and a tool bring with them is code: symbolic/perform.cpp and symbolic/treat.cpp,
/// and pddl/action_rows.cpp and pddl/domain_actions.cpp. So are going and standing up. simulation/ performs all actions
/// in code of its own, and tests hold the three together.
std::span<const ActionInfo, kActionCount> action_table();

/// The rows of the failures, in the order of Failure.
std::span<const FailureInfo, kFailureCount> failure_table();

}  // namespace unietp
