#pragma once

#include <string>
#include <vector>

#include "scene/action.h"

namespace unietp::pddl {

/// Preconditions or effects of an action, each in PDDL.
using Lines = std::vector<std::string>;
/// One list after the other.
Lines joined(Lines first, const Lines& second);

/// "(when (and condition) (and effects))".
std::string when(const std::string& condition, const std::string& effects);
/// "(forall (variables) effect)".
std::string for_all(const std::string& variables, const std::string& effect);

/// Whether the row of an action has such a need.
bool asks(const ActionInfo& action, ActionNeed::Kind kind);

/// What an action needs by this rule of its row in scene/action_table.h: of the target ?t, of what the hand holds, ?x,
/// and of the substance ?s in it. `seats`: agents may sit. `in_hand`: where the target may be held, it is; else it is
/// in reach.
Lines row_needs(const ActionInfo& action, bool seats, ActionRule rule = ActionRule::Always, bool in_hand = false);

/// What an action changes by this rule of its row, with all that moves along, and ?r, the room where things are
/// dropped. What tools do then is not in it.
Lines row_effects(const ActionInfo& action, ActionRule rule = ActionRule::Always);

}  // namespace unietp::pddl
