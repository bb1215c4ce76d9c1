#include "validator/must_fail.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/text.h"
#include "logic/constraints.h"
#include "logic/evaluate.h"
#include "simulation/mode_episode.h"
#include "simulation/view.h"
#include "validator/conjuncts.h"

namespace unietp {
namespace {

using Op = Formula::Op;

bool asks_for_order(const Formula& goal) {
  return goal.op == Op::Before || goal.op == Op::Until ||
         std::any_of(goal.children.begin(), goal.children.end(), asks_for_order);
}

bool puts_down(ActionType type) {
  return type == ActionType::PlaceOn || type == ActionType::PlaceIn || type == ActionType::Drop;
}

bool handles(ActionType type) {
  const ActionClass group = info(type).group;
  return group == ActionClass::Manipulation || group == ActionClass::Composite;
}

/// Whether the boxes of a command are large enough in the image for an agent to identify the objects: some steps only
/// serve to see an object better.
bool can_be_identified(const Command& command) {
  return std::all_of(command.args.begin(), command.args.end(),
                     [](const Argument& argument) { return !argument.box || shows_clearly(*argument.box); });
}

/// An episode, with the commands so far and the changes from moment to moment.
struct Rollout {
  ModeEpisode episode;
  std::vector<Command> commands = {};
  std::vector<Delta> changes = {};
  bool did_something = false;  // whether the last action changed a thing

  void act(const Action& action) {
    did_something = false;
    const auto command = episode.command_for(action);
    if (!command || !can_be_identified(*command)) return;
    const bool done = episode.step(*command).success;
    commands.push_back(*command);
    if (!done) return;
    did_something = !episode.world().changes().nodes.empty();
    for (Delta& change : episode.world().changes_by_moment()) changes.push_back(std::move(change));
  }
};

std::vector<StateSet> states_held(const World& world) {
  std::vector<StateSet> states;
  for (const auto& id : world.agent().held) {
    if (const Node* node = world.find(id)) states.push_back(node->states);
  }
  return states;
}

class PlanChanger {
 public:
  PlanChanger(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces, std::string where)
      : goal_(goal),
        asked_(without_constraints(goal)),
        start_{ModeEpisode(start, mode)},
        traces_(traces),
        where_(std::move(where)) {}

  void leave_out_each(const std::vector<Action>& plan, const StepMarks& marks) {
    Rollout here = start_;
    for (std::size_t i = 0; i < plan.size(); ++i) {
      if (marks.is_search(i) || marks.is_tidying(i)) {
        here.act(plan[i]);
        continue;
      }
      Rollout without = here;
      const bool kept = puts_down(plan[i].type);
      if (reaches_goal(kept ? PlanChange::KeptInHand : PlanChange::MissingStep, without,
                       std::span(plan).subspan(i + 1))) {
        const auto step = "step " + std::to_string(i + 1) + " " + to_text(plan[i]);
        if (kept) {
          found(ProblemKind::LeftInHand,
                "the goal is also reached if the object that " + step + " puts down stays in the hand");
        } else {
          found(ProblemKind::NeedlessStep, "the goal is also reached without " + step);
        }
      }
      here.act(plan[i]);
    }
  }

  void change_order(const std::vector<Action>& plan) {
    if (!asks_for_order(goal_)) return;
    const auto parts = parts_of(plan);
    if (parts.size() < 2) return;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      auto swapped = parts;
      std::swap(swapped[i], swapped[i + 1]);
      if (!survives(PlanChange::SwappedParts, swapped)) return;
    }
    if (!survives(PlanChange::ReversedParts, {parts.rbegin(), parts.rend()})) return;
    found(ProblemKind::AnyOrder,
          "the goal requires an order, but is also reached with any two neighboring parts of the plan "
          "swapped, and with all of them reversed");
  }

  void use_distractors(const std::vector<Action>& plan) {
    const Trace start = traces_.at_start();
    for (const ReferringDomain& one : referring_domains(goal_)) {
      Domain whole = one.domain;
      whole.where.clear();
      const auto referents = members_of(one.domain, one.variable, start);
      std::vector<std::string> excluded;
      for (const EntityIndex other : members_of(whole, one.variable, start)) {
        if (std::find(referents.begin(), referents.end(), other) == referents.end())
          excluded.push_back(start.entities[other].id);
      }
      for (const EntityIndex referent : referents) {
        const std::string& id = start.entities[referent].id;
        for (const std::string& other : those_around(id, excluded)) use_instead(id, other, plan);
      }
    }
  }

  MustFail take() { return std::move(done_); }

 private:
  void found(ProblemKind kind, std::string message) {
    done_.problems.push_back(problem_in(kind, where_, std::move(message)));
  }

  bool reaches_goal(PlanChange change, Rollout& rollout, std::span<const Action> rest) {
    for (const Action& action : rest) rollout.act(action);
    const Trace trace = traces_.of(rollout.changes);
    const bool reached = holds(goal_, trace);
    const bool breaks = !reached && asked_ != goal_ && holds(asked_, trace);
    rollout.commands.push_back(by_ids({ActionType::Stop, {}}));
    done_.plans.push_back({change, std::move(rollout.commands), reached, breaks});
    return reached;
  }

  bool survives(PlanChange change, const std::vector<std::vector<Action>>& parts) {
    std::vector<Action> plan;
    for (const auto& part : parts) plan.insert(plan.end(), part.begin(), part.end());
    Rollout rollout = start_;
    return reaches_goal(change, rollout, plan);
  }

  /// The plan cut wherever something was done and the hands are empty, and where what they hold became another: what
  /// was filled and is then heated is two parts, whatever was switched on between.
  std::vector<std::vector<Action>> parts_of(const std::vector<Action>& plan) const {
    std::vector<std::vector<Action>> parts;
    std::vector<Action> part;
    Rollout rollout = start_;
    for (const Action& action : plan) {
      const auto held = states_held(rollout.episode.world());
      rollout.act(action);
      part.push_back(action);
      const auto holds_now = states_held(rollout.episode.world());
      const bool became = !held.empty() && holds_now.size() == held.size() && holds_now != held;
      if (!rollout.did_something || (!holds_now.empty() && !became)) continue;
      parts.push_back(std::move(part));
      part.clear();
    }
    return parts;
  }

  /// Of the ids the eight whose things lie nearest to a thing, equally near ones in their order.
  std::vector<std::string> those_around(const std::string& id, const std::vector<std::string>& ids) const {
    const World& world = start_.episode.world();
    const Node* center = world.find(id);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const Node* node = world.find(ids[i]);
      const bool stand = center != nullptr && node != nullptr;
      order.emplace_back(stand ? (center->pose.position - node->pose.position).norm() : 0, i);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::string> around;
    for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 8); ++i) around.push_back(ids[order[i].second]);
    return around;
  }

  void use_instead(const std::string& referent, const std::string& other, const std::vector<Action>& plan) {
    std::vector<Action> altered = plan;
    bool used = false;
    for (Action& action : altered) {
      for (std::string& argument : action.args) {
        if (argument != referent) continue;
        argument = other;
        used = used || handles(action.type);
      }
    }
    Rollout rollout = start_;
    if (used && reaches_goal(PlanChange::Distractor, rollout, altered))
      found(ProblemKind::DistractorServes, "the goal is also reached with " + other + " instead of " + referent);
  }

  const Formula& goal_;
  Formula asked_;  // without its constraints
  Rollout start_;
  const TraceMaker& traces_;
  std::string where_;
  MustFail done_;
};

}  // namespace

std::string_view name_of(PlanChange change) {
  switch (change) {
    case PlanChange::MissingStep:
      return "missing-step";
    case PlanChange::KeptInHand:
      return "kept-in-hand";
    case PlanChange::SwappedParts:
      return "swapped-parts";
    case PlanChange::ReversedParts:
      return "reversed-parts";
    case PlanChange::Distractor:
      return "distractor";
    case PlanChange::Tempting:
      return "tempting";
  }
  return "";
}

MustFail must_fail(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces,
                   const std::vector<Action>& plan, const StepMarks& marks, const std::string& where) {
  PlanChanger changer(goal, start, mode, traces, where);
  changer.leave_out_each(plan, marks);
  std::vector<Action> for_the_goal;
  for (std::size_t i = 0; i < plan.size(); ++i)
    if (!marks.is_tidying(i)) for_the_goal.push_back(plan[i]);
  changer.change_order(for_the_goal);
  changer.use_distractors(for_the_goal);
  return changer.take();
}

std::optional<AlteredPlan> run_tempting(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces,
                                        const std::vector<Command>& tempting) {
  Rollout rollout{ModeEpisode(start, mode)};
  for (const Command& command : tempting) {
    const auto type = action_named(command.action);
    if (!type) return std::nullopt;
    Action action{*type, {}};
    for (const Argument& argument : command.args) action.args.push_back(argument.id);
    const auto said = rollout.commands.size();
    const int failures = rollout.episode.failures();
    rollout.act(action);
    if (rollout.commands.size() == said || rollout.episode.failures() != failures) return std::nullopt;
  }
  const Trace trace = traces.of(rollout.changes);
  const bool reached = holds(goal, trace);
  const auto readings = hasty_readings(goal);
  const bool breaks = !reached && std::any_of(readings.begin(), readings.end(),
                                              [&](const HastyReading& reading) { return holds(reading.goal, trace); });
  return AlteredPlan{PlanChange::Tempting, std::move(rollout.commands), reached, breaks};
}

}  // namespace unietp
