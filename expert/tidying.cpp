#include "expert/tidying.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "expert/execution.h"
#include "expert/rollout.h"
#include "expert/search_marks.h"

namespace unietp {
namespace {

bool does_all(Rollout& rollout, std::span<const Action> actions) {
  return std::all_of(actions.begin(), actions.end(),
                     [&](const Action& action) { return rollout.go_on(action).success; });
}

/// What a careful person sets back: an action, the state that it brings about, and the action that ends it.
struct SetBack {
  ActionType did;
  Predicate state;
  ActionType undoes;
};
constexpr std::array kSetBack{SetBack{ActionType::Open, Predicate::Open, ActionType::Close},
                              SetBack{ActionType::TurnOn, Predicate::PowerOn, ActionType::TurnOff}};

/// A thing and what is to be set back of it.
struct LeftBehind {
  const SetBack* what = nullptr;
  std::string id;
  bool operator==(const LeftBehind&) const = default;
  bool in(const World& world) const {
    const Node* node = world.find(id);
    return node != nullptr && node->states.has(what->state);
  }
  bool from(const Action& action) const { return action.type == what->did && action.args.front() == id; }
};

/// What the actions opened or turned on and left so, in the order in which that was done.
std::vector<LeftBehind> left_behind(ExecutionTree& executions, const ModeRules& rules,
                                    const std::vector<Action>& actions, const std::vector<std::string>& opened) {
  std::vector<LeftBehind> left;
  for (const std::string& id : opened) left.push_back({kSetBack.data(), id});
  Rollout all(executions, rules);
  all.go_on(actions);
  for (const Action& action : all.done()) {
    const auto what =
        std::find_if(kSetBack.begin(), kSetBack.end(), [&](const auto& x) { return x.did == action.type; });
    if (what == kSetBack.end()) continue;
    LeftBehind one{&*what, action.args.front()};
    if (one.in(executions.world()) || std::find(left.begin(), left.end(), one) != left.end()) continue;
    left.push_back(std::move(one));
  }
  std::erase_if(left, [&](const LeftBehind& one) { return !one.in(all.episode().world()); });
  return left;
}

/// How to come to set a thing back, shortest first.
std::vector<std::vector<Action>> ways_to_set_back(const LeftBehind& left, Mode mode) {
  const Action undo{left.what->undoes, {left.id}};
  std::vector<std::vector<Action>> ways{{undo}};
  for (const ActionType type : {ActionType::TurnTo, ActionType::GoTo})
    if (offers(info(type), mode)) ways.push_back({{type, {left.id}}, undo});
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
      : steps_(demonstration.steps), start_(executions, rules_with_full_knowledge(demonstration.steps.size())) {}

  void mark() {
    std::set<std::pair<ActionType, std::string>> done;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const Action& action = steps_[i].action;
      for (const SetBack& what : kSetBack) {
        if (action.type == what.did) done.emplace(what.did, action.args.front());
        if (action.type == what.undoes && done.contains({what.did, action.args.front()})) mark_step(i);
      }
    }
  }

 private:
  void mark_step(std::size_t i) {
    if (!mark_if_missed(i)) return;
    while (i > 0 && only_leads_somewhere(steps_[i - 1].action) && mark_if_missed(i - 1)) --i;
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
  for (const LeftBehind& left : left_behind(executions, rules, actions, opened)) {
    const auto last = std::find_if(actions.rbegin(), actions.rend(), [&](const Action& a) { return left.from(a); });
    const auto first = std::max(done, static_cast<std::size_t>(actions.rend() - last));
    for (const auto& way : ways_to_set_back(left, rules.mode)) {
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
