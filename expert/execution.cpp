#include "expert/execution.h"

#include "expert/situation.h"
#include "logic/evaluate.h"

namespace unietp {

bool goal_holds(const Formula& goal, const Scene& start, const std::vector<Delta>& changes) {
  return holds(goal, to_logic(start, changes, reads_comparisons(goal)));
}

void perform(World& world, const std::vector<Action>& actions, std::vector<Delta>& changes) {
  for (const Action& action : actions) {
    const Scene before = world.scene();
    world.step(action);
    changes.push_back(difference(before, world.scene()));
  }
}

Demonstration record(World world, const std::vector<Action>& actions) {
  Demonstration demonstration;
  for (const Action& action : actions) {
    const Scene before = world.scene();
    DemonstrationStep step;
    step.visible = world.visible();
    step.action = action;
    step.command = by_ids(action);
    step.outcome = world.step(action);
    step.changes = difference(before, world.scene());
    demonstration.steps.push_back(std::move(step));
  }
  return demonstration;
}

namespace {

/// Changes of the actions from `first` on, or nothing when one of them fails.
std::optional<std::vector<Delta>> all_succeed(World world, const std::vector<Action>& actions, std::size_t first) {
  std::vector<Delta> changes;
  for (std::size_t i = first; i < actions.size(); ++i) {
    const Scene before = world.scene();
    if (!world.step(actions[i]).success) return std::nullopt;
    changes.push_back(difference(before, world.scene()));
  }
  return changes;
}

}  // namespace

std::vector<Action> without_needless(const Formula& goal, const Scene& start, const World& world,
                                     std::vector<Action> actions, std::size_t longest_run) {
  std::size_t run = 1;
  while (run <= longest_run) {
    World here = world;
    std::vector<Delta> so_far;
    std::size_t i = 0;
    bool shortened = false;
    while (i + run < actions.size()) {
      const auto position = actions.begin() + static_cast<std::ptrdiff_t>(i);
      std::vector<Action> shorter(actions.begin(), position);
      shorter.insert(shorter.end(), position + static_cast<std::ptrdiff_t>(run), actions.end());
      if (const auto rest = all_succeed(here, shorter, i)) {
        std::vector<Delta> changes = so_far;
        changes.insert(changes.end(), rest->begin(), rest->end());
        if (goal_holds(goal, start, changes)) {
          actions = std::move(shorter);
          shortened = true;
          continue;
        }
      }
      perform(here, {actions[i]}, so_far);
      ++i;
    }
    // A shorter plan may make a step needless that was needed before.
    run = shortened ? 1 : run + 1;
  }
  return actions;
}

}  // namespace unietp
