#pragma once

#include <vector>

#include "pddl/domain.h"

namespace unietp::pddl {

/// Actions that change the states of one thing alone, from scene/action_table.h, and standing up from a seat. Without
/// those that start what a tool does (open, close, turn_on, turn_off), which domain_actions.cpp writes.
std::vector<ActionText> direct_actions(const ActionSet& offered);

}  // namespace unietp::pddl
