#include "expert/execution.h"

#include "logic/evaluate.h"

namespace unietp {

bool goal_holds(const Formula& goal, const Scene& start, const std::vector<Delta>& changes) {
  return holds(goal, to_logic(start, changes, reads_comparisons(goal)));
}

Demonstration record(Rehearsal& rehearsal, const std::vector<Action>& actions) {
  Demonstration demonstration;
  World world = rehearsal.world();
  for (const Action& action : actions) {
    DemonstrationStep step;
    step.visible = world.visible();
    step.action = action;
    step.command = by_ids(action);
    step.outcome = rehearsal.step(world, action);
    step.changes = world.changes();
    demonstration.steps.push_back(std::move(step));
  }
  return demonstration;
}

std::vector<Action> without_needless(Rehearsal& rehearsal, std::vector<Action> actions, std::size_t longest_run) {
  std::size_t run = 1;
  while (run <= longest_run) {
    auto here = rehearsal.course();
    std::size_t i = 0;
    bool shortened = false;
    while (i + run < actions.size()) {
      auto shorter = here;
      rehearsal.follow(shorter, std::span(actions).subspan(i + run));
      if (shorter.all_succeeded && rehearsal.reaches_goal(shorter)) {
        const auto at = actions.begin() + static_cast<std::ptrdiff_t>(i);
        actions.erase(at, at + static_cast<std::ptrdiff_t>(run));
        shortened = true;
        continue;
      }
      rehearsal.follow(here, std::span(actions).subspan(i, 1));
      ++i;
    }
    // A shorter plan may make a step needless that was needed before.
    run = shortened ? 1 : run + 1;
  }
  return actions;
}

}  // namespace unietp
