#include "expert/execution.h"

#include <algorithm>

#include "expert/rollout.h"

namespace unietp {
namespace {

bool puts_down(ActionType type) {
  return type == ActionType::PlaceOn || type == ActionType::PlaceIn || type == ActionType::Drop;
}

/// Leaves out runs of this length wherever the goal holds without them; true when some went.
bool shorten(const Rollout& start, std::vector<Action>& actions, std::size_t length) {
  bool shorter = false;
  Rollout so_far = start;
  for (std::size_t i = start.done().size(); i + length < actions.size();) {  // the last is `stop`
    Rollout without = so_far;
    without.go_on(std::span(actions).subspan(i + length));
    if (without.reaches_goal()) {
      actions = without.done();
      shorter = true;
      continue;
    }
    (void)so_far.go_on(actions[i]);
    ++i;
  }
  return shorter;
}

bool leave_in_hand(const Rollout& start, std::vector<Action>& actions) {
  for (const LeftInHand& mutant : left_in_hand(actions)) {
    Rollout rollout = start;
    rollout.go_on(mutant.actions);
    if (!rollout.reaches_goal()) continue;
    actions = rollout.done();
    return true;
  }
  return false;
}

}  // namespace

bool only_leads_somewhere(const Action& action) {
  const ActionClass group = info(action.type).group;
  return group == ActionClass::Movement || group == ActionClass::Reach;
}

Demonstration record(ExecutionTree& executions, Mode mode, const std::vector<Action>& actions) {
  Demonstration demonstration;
  demonstration.mode = mode;
  Rollout rollout(executions, rules_of(mode));
  for (const Action& action : actions) {
    auto command = clearly_said(rollout.episode(), action);
    if (!command) continue;
    DemonstrationStep step;
    step.visible = rollout.episode().visible();
    step.action = action;
    step.command = std::move(*command);
    step.outcome = rollout.go_on(action);
    if (step.outcome.success) {
      const World& world = rollout.episode().world();
      step.changes = world.changes();
      if (!world.passed().empty()) step.moments = world.changes_by_moment();
    }
    demonstration.steps.push_back(std::move(step));
  }
  return demonstration;
}

std::optional<std::vector<Action>> without_needless(ExecutionTree& executions, const ModeRules& rules,
                                                    std::vector<Action> actions, std::size_t longest_run,
                                                    std::size_t done) {
  Rollout start(executions, rules);
  start.go_on(std::span(actions).first(done));
  if (start.done().size() != done) return std::nullopt;
  Rollout all = start;
  all.go_on(std::span(actions).subspan(done));
  if (!all.reaches_goal()) return std::nullopt;
  actions = all.done();
  for (std::size_t length = 1;;) {
    // A shorter plan may make a step needless that was needed before.
    if (length <= longest_run) {
      length = shorten(start, actions, length) ? 1 : length + 1;
    } else if (done == 0 && leave_in_hand(start, actions)) {
      length = 1;
    } else {
      return actions;
    }
  }
}

std::vector<LeftInHand> left_in_hand(const std::vector<Action>& actions) {
  std::vector<LeftInHand> mutants;
  for (std::size_t down = 0; down + 1 < actions.size(); ++down) {  // what ends with putting down is no whole plan
    if (!puts_down(actions[down].type)) continue;
    std::size_t begin = down;
    while (begin > 0 && actions[begin].type != ActionType::PickUp) --begin;
    if (actions[begin].type != ActionType::PickUp) continue;
    const std::string& thing = actions[begin].args.front();
    while (begin > 0 && only_leads_somewhere(actions[begin - 1])) --begin;
    const auto at = [&actions](std::size_t i) { return actions.begin() + static_cast<std::ptrdiff_t>(i); };
    LeftInHand mutant{thing, {at(0), at(begin)}};
    mutant.actions.insert(mutant.actions.end(), at(down + 1), actions.end() - 1);
    mutant.actions.insert(mutant.actions.end(), at(begin), at(down));
    mutant.actions.push_back(actions.back());
    mutants.push_back(std::move(mutant));
  }
  return mutants;
}

}  // namespace unietp
