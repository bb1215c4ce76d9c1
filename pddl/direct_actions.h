#pragma once

#include <vector>

#include "pddl/domain.h"

namespace unietp::pddl {

/// What an action needs of the thing ?t and the hand, from its row in scene/action_table.h; where the thing is, is
/// asked apart, and so is what only a rule of the simulator asks for.
std::vector<std::string> own_needs(const ActionInfo& action);
/// What an action with this rule needs besides; empty for an action without it.
std::vector<std::string> needs_by_rule(const ActionInfo& action, ActionRule rule);
/// The changes of the row.
std::vector<std::string> own_effects(const ActionInfo& action);

/// Actions that change the states of one thing alone, and standing up from a seat. Without those that start what a tool
/// does (open, close, turn_on, turn_off): domain_actions.cpp adds that to what their rows say.
std::vector<ActionText> direct_actions(const ActionSet& offered);

}  // namespace unietp::pddl
