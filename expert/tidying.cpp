#include "expert/tidying.h"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "expert/rollout.h"
#include "expert/search_marks.h"

namespace unietp {
namespace {

bool does_all(Rollout& rollout, std::span<const Action> actions) {
  return std::all_of(actions.begin(), actions.end(),
                     [&](const Action& action) { return rollout.go_on(action).success; });
}

bool is_open(const Node* node) { return node != nullptr && node->states.has(Predicate::Open); }

bool opens(const Action& action, const std::string& id) {
  return action.type == ActionType::Open && action.args.front() == id;
}

/// What the actions opened and left open, in the order in which it was opened.
std::vector<std::string> left_open(ExecutionTree& executions, const ModeRules& rules,
                                   const std::vector<Action>& actions, std::vector<std::string> opened) {
  Rollout all(executions, rules);
  all.go_on(actions);
  for (const Action& action : all.done()) {
    if (action.type != ActionType::Open || is_open(executions.world().find(action.args.front()))) continue;
    if (std::find(opened.begin(), opened.end(), action.args.front()) == opened.end())
      opened.push_back(action.args.front());
  }
  std::erase_if(opened, [&](const std::string& id) { return !is_open(all.episode().world().find(id)); });
  return opened;
}

/// How to come to close a thing, shortest first.
std::vector<std::vector<Action>> ways_to_close(const std::string& id, Mode mode) {
  const Action close{ActionType::Close, {id}};
  std::vector<std::vector<Action>> ways{{close}};
  for (const ActionType type : {ActionType::TurnTo, ActionType::GoTo})
    if (offers(info(type), mode)) ways.push_back({{type, {id}}, close});
  return ways;
}

/// The actions with the steps at the first place where they and all that comes after them work.
std::optional<std::vector<Action>> with_steps(ExecutionTree& executions, const ModeRules& rules,
                                              const std::vector<Action>& actions, std::size_t first,
                                              const std::vector<Action>& steps) {
  Rollout here(executions, rules);
  if (!does_all(here, std::span(actions).first(first))) return std::nullopt;
  for (std::size_t at = first; at < actions.size(); ++at) {
    Rollout trial = here;
    if (does_all(trial, steps) && does_all(trial, std::span(actions).subspan(at)) && trial.reaches_goal())
      return trial.done();
    (void)here.go_on(actions[at]);
  }
  return std::nullopt;
}

/// Each step is judged without those that are marked already, so that all of them can be missed together.
class TidyingMarker {
 public:
  TidyingMarker(ExecutionTree& executions, Demonstration& demonstration)
      : steps_(demonstration.steps), start_(executions, rules_of_the_told(demonstration.steps.size())) {}

  void mark() {
    std::set<std::string> opened;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const Action& action = steps_[i].action;
      if (action.type == ActionType::Open) opened.insert(action.args.front());
      if (action.type == ActionType::Close && opened.contains(action.args.front())) mark_close(i);
    }
  }

 private:
  void mark_close(std::size_t i) {
    if (!mark_if_missed(i)) return;
    while (i > 0 && only_leads_somewhere(steps_[i - 1].action.type) && mark_if_missed(i - 1)) --i;
  }

  static bool only_leads_somewhere(ActionType type) {
    const ActionClass group = info(type).group;
    return group == ActionClass::Movement || group == ActionClass::Reach;
  }

  bool mark_if_missed(std::size_t i) {
    steps_[i].tidying = true;
    Rollout without = start_;
    for (const DemonstrationStep& step : steps_)
      if (!step.tidying) (void)without.go_on(step.action);
    return steps_[i].tidying = without.reaches_goal();
  }

  std::vector<DemonstrationStep>& steps_;
  Rollout start_;
};

}  // namespace

std::vector<Action> tidied(ExecutionTree& executions, const ModeRules& rules, std::vector<Action> actions,
                           std::size_t done, const std::vector<std::string>& opened) {
  const auto most = static_cast<std::size_t>(rules.limits.steps);
  for (const std::string& id : left_open(executions, rules, actions, opened)) {
    const auto last = std::find_if(actions.rbegin(), actions.rend(), [&](const Action& a) { return opens(a, id); });
    const auto first = std::max(done, static_cast<std::size_t>(actions.rend() - last));
    for (const auto& way : ways_to_close(id, rules.mode)) {
      if (actions.size() + way.size() > most) break;
      auto longer = with_steps(executions, rules, actions, first, way);
      if (!longer) continue;
      actions = std::move(*longer);
      break;
    }
  }
  return actions;
}

void mark_tidying(ExecutionTree& executions, Demonstration& demonstration) {
  TidyingMarker(executions, demonstration).mark();
}

}  // namespace unietp
