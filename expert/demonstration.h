#pragma once

#include <vector>

#include "scene/action.h"
#include "scene/command.h"
#include "scene/trace.h"
#include "scene/visible_object.h"
#include "simulation/outcome.h"

namespace unietp {

/// One executed step from the agent's side: what it saw, what it did, the feedback and what changed.
struct DemonstrationStep {
  std::vector<VisibleObject> visible;  // before the action
  Action action;                       // on ids, whatever the mode
  Command command;                     // how an agent of the mode says it
  Outcome outcome;
  Delta changes;
  std::vector<Delta> moments = {};  // from moment to moment, where the action passes through several; else empty
  bool search = false;              // only served to see something (search_marks.h)
  bool tidying = false;             // only sets back what was opened or turned on before (tidying.h)
};

/// An executed plan under the rules of a mode.
struct Demonstration {
  Mode mode = Mode::M1;
  std::vector<DemonstrationStep> steps;  // the last is `stop`
  /// M2 and M3: the shortest plan known to one who is told everything, with the actions of the mode; ends with `stop`.
  std::vector<Action> shortest = {};
  /// M1, where the goal has constraints: a plan that breaks them (tempting_plan.h); ends with `stop`.
  std::vector<Action> tempting = {};
};

/// The actions of a demonstration but for those that only tidy up.
inline std::vector<Action> actions_for_the_goal(const Demonstration& demonstration) {
  std::vector<Action> actions;
  for (const DemonstrationStep& step : demonstration.steps)
    if (!step.tidying) actions.push_back(step.action);
  return actions;
}
/// Length of the shortest plan; in M1 0 where it is the demonstration itself.
inline int shortest_steps(const Demonstration& demonstration) {
  if (demonstration.mode != Mode::M1) return static_cast<int>(demonstration.shortest.size());
  const std::size_t needed = actions_for_the_goal(demonstration).size();
  return needed == demonstration.steps.size() ? 0 : static_cast<int>(needed);
}

/// Limits of the search for a plan.
struct ExpertOptions {
  int max_steps = 50, max_failures = 10;  // stages.md: M1 and M2
  int max_plans = 12;                     // alternative orders and witnesses tried
  Mode mode = Mode::M1;                   // whose actions are used; its other rules are not kept (mode_expert.h)
};

}  // namespace unietp
