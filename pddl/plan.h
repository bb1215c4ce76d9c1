#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "pddl/problem.h"
#include "scene/action.h"
#include "symbolic/goal.h"
#include "symbolic/perform.h"

namespace unietp::pddl {

/// A plan for the problem from actions that succeeded in physics, one action per line, with `note` and `judge` where
/// the problem has monitors. Actions of the body and the camera are left out, a go_to is inserted where a target was
/// already within reach in physics, and what only physics needs is left out: without any one of its steps the plan
/// fails or does not reach the goal. `pieces`: (id in physics, id of its whole) in the order in which they were cut.
/// Errors: Unsatisfiable, with the step, when its preconditions do not hold, or when the goal does not hold after the
/// last step (a held object is in no room here).
Result<std::vector<std::string>> plan_for(const symbolic::Setting& setting, const symbolic::World& start,
                                          const symbolic::Goal& goal, const Problem& problem,
                                          const std::vector<Action>& actions,
                                          const std::vector<std::pair<std::string, std::string>>& pieces);

/// The steps that a step in `world` is written as: a composite action step by step where the problem has monitors,
/// which see each moment of it.
std::vector<symbolic::Step> written_as(const symbolic::Setting& setting, const Problem& problem,
                                       const symbolic::World& world, const symbolic::Step& step);
/// One step as an action of the domain, applied in `world`: "(place_on mug_1 table_1)".
std::string step_text(const symbolic::Setting& setting, const Problem& problem, const symbolic::World& world,
                      const symbolic::Step& step);

}  // namespace unietp::pddl
