#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "pddl/problem.h"
#include "scene/action.h"
#include "symbolic/goal.h"
#include "symbolic/perform.h"

namespace unietp::pddl {

/// A plan of the problem from actions that succeeded in physics, one line an action, `note` and `judge` among them
/// where monitors are kept. Actions of the body and the camera are left out; going to what physics had within reach is
/// put in. `pieces`: (id in physics, id of its whole) in the order of their making.
/// Errors: Unsatisfiable when the symbols do not allow a step, which it names, or when the goal does not hold after the
/// last one: what is in the hand is in no room there.
Result<std::vector<std::string>> plan_for(const symbolic::Setting& setting, const symbolic::World& start,
                                          const symbolic::Goal& goal, const Problem& problem,
                                          const std::vector<Action>& actions,
                                          const std::vector<std::pair<std::string, std::string>>& pieces);

/// One step in the domain's actions, as things are in `world`; "(place_on mug_1 table_1)".
std::string step_text(const symbolic::Setting& setting, const Problem& problem, const symbolic::World& world,
                      const symbolic::Step& step);

}  // namespace unietp::pddl
