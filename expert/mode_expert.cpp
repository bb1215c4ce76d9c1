#include "expert/mode_expert.h"

#include <algorithm>
#include <set>
#include <span>
#include <utility>

#include "expert/execution.h"
#include "expert/exploration.h"
#include "expert/rollout.h"

namespace unietp {
namespace {

/// Why a plan could not be carried out in a mode.
struct Trouble {
  std::string text;                 // for people
  Failure failure = Failure::None;  // of the last action; NotSeenYet for a thing that was looked for in vain
};

/// Carries out a plan that names things by ids, looking for each thing first.
class Explorer {
 public:
  Explorer(ExecutionTree& executions, Mode mode) : rollout_(executions, mode) {}
  /// From now on it looks around from where it stands, also where it would see a thing sooner from elsewhere.
  void stay() { stays_ = true; }

  bool carry_out(const Action& action) {
    const bool of_object = !action.args.empty() && world().find(action.args.front()) != nullptr;
    if (!of_object) return act(action);
    const std::string& id = action.args.front();
    // Who has come to stand where something works had better look around without leaving.
    const bool stays = stays_ && action.type != ActionType::GoTo;
    if (!can_say(action) && !(stays && look(id, Viewpoint::Here)) && !see(id)) return unseen(id);
    if (act(action)) return true;
    if (action.type == ActionType::GoTo) return false;
    // Perhaps from nearer by: where one is led to, or wherever the arm reaches it and the camera shows it.
    const Action approach{ActionType::GoTo, {id}};
    if ((can_say(approach) || see(id)) && act(approach) && can_say(action) && act(action)) return true;
    return look(id, Viewpoint::InReach) && act(action);
  }

  /// Does what comes before `stop`; true when the goal is reached then, else `trouble` says why not.
  bool follow(std::span<const Action> plan) {
    lost_.clear();
    for (const Action& action : plan.first(plan.size() - 1)) {
      if (carry_out(action)) continue;
      trouble_.text = "for " + to_text(action) + ": " + trouble_.text;
      if (!action.args.empty()) lost_ = action.args.front();
      return false;
    }
    trouble_ = {"done so, it does not reach the goal"};
    return rollout_.reaches_goal();
  }

  const std::vector<Action>& done() const { return rollout_.done(); }
  const Trouble& trouble() const { return trouble_; }
  const std::string& lost() const { return lost_; }  // what was not come to, or could not be used; or ""
  bool over() const { return rollout_.episode().over(); }

 private:
  static constexpr int kMostDetours = 2;

  const World& world() const { return rollout_.episode().world(); }
  bool can_say(const Action& action) const { return clearly_said(rollout_.episode(), action).has_value(); }
  bool unseen(const std::string& id) {
    trouble_ = {id + " cannot be found", Failure::NotSeenYet};
    return false;
  }
  bool act(const Action& action) {
    const Outcome outcome = rollout_.go_on(action);
    if (!outcome.success) trouble_ = {to_text(action) + ": " + outcome.feedback, outcome.failure};
    return outcome.success;
  }
  bool look(const std::string& id, Viewpoint standing = Viewpoint::Anywhere) {
    const auto way = way_to_see(rollout_.episode(), id, standing);
    return way && std::all_of(way->begin(), way->end(), [this](const Action& step) { return act(step); });
  }
  /// Looks from here, from the room, and from furniture; furniture that is not in view itself is looked for first.
  bool see(const std::string& id, int detours = 0) {
    if (look(id)) return true;
    if (detours == kMostDetours) return false;
    const Rollout before = rollout_;
    for (const std::string& lookout : lookouts_for(world(), id)) {
      const Action approach{ActionType::GoTo, {lookout}};
      if (can_say(approach) || !see(lookout, detours + 1) || !act(approach)) continue;
      if (look(id)) return true;
    }
    return detours == 0 && see_from_nearby(id, before);
  }
  /// Where long steps and wide turns lead to few places, each thing nearby that is gone to leads to others. Once for
  /// each thing that is not found so.
  bool see_from_nearby(const std::string& id, const Rollout& before) {
    if (given_up_.contains(id)) return false;
    for (const std::string& other : things_near(world(), id)) {
      rollout_ = before;
      const Action approach{ActionType::GoTo, {other}};
      if ((can_say(approach) || look(other)) && act(approach) && look(id)) return true;
    }
    rollout_ = before;
    given_up_.insert(id);
    return false;
  }

  Rollout rollout_;
  bool stays_ = false;
  std::set<std::string> given_up_;
  Trouble trouble_;
  std::string lost_;
};

/// Does a plan as the mode allows it. Where that does not go as planned, since who looks for things comes to stand
/// elsewhere, the rest is planned anew from there; or all of it, with other things where others will do. Gives what was
/// done, without `stop`.
std::variant<std::vector<Action>, Trouble> explore(Mode mode, ExecutionTree& executions, std::vector<Action> plan,
                                                   const ExpertOptions& options) {
  constexpr int kMostReplans = 4;
  Explorer explorer(executions, mode);
  ExecutedPrefix beginning;
  for (int replans = 0; !explorer.follow(plan); ++replans) {
    const Trouble trouble = explorer.trouble();
    if (replans == kMostReplans) return trouble;
    if (!explorer.lost().empty()) beginning.avoided.push_back(explorer.lost());
    const bool goes_on = replans % 2 == 0 && !explorer.over();
    beginning.clears = replans >= kMostReplans / 2;
    beginning.done = goes_on ? explorer.done() : std::vector<Action>{};
    auto other = find_plan_from(executions, beginning, options);
    if (std::holds_alternative<Rejection>(other) && goes_on) {
      beginning.done.clear();
      other = find_plan_from(executions, beginning, options);
    }
    if (std::holds_alternative<Rejection>(other)) return trouble;
    plan = std::move(std::get<std::vector<Action>>(other));
    if (beginning.done.empty()) explorer = Explorer(executions, mode);
    explorer.stay();
  }
  return explorer.done();
}

std::vector<Action> actions_of(const Demonstration& shown) {
  std::vector<Action> actions;
  for (const DemonstrationStep& step : shown.steps) actions.push_back(step.action);
  return actions;
}

RejectionReason not_in(Mode mode) { return mode == Mode::M2 ? RejectionReason::NotInM2 : RejectionReason::NotInM3; }

/// A state that every way to make the formula true brings about, and that has an action which the mode does not offer.
std::optional<Predicate> state_without_action(Mode mode, const Formula& formula) {
  switch (formula.op) {
    case Formula::Op::Atom: {
      const auto action = direct_action(formula.predicate);
      return action && !offers(info(*action), mode) ? std::optional(formula.predicate) : std::nullopt;
    }
    case Formula::Op::And:
    case Formula::Op::Before:
      for (const Formula& part : formula.children) {
        if (const auto state = state_without_action(mode, part)) return state;
      }
      return std::nullopt;
    case Formula::Op::AtEnd:
    case Formula::Op::Sometime:
    case Formula::Op::Exists:
    case Formula::Op::Forall:
      return state_without_action(mode, formula.children.front());
    case Formula::Op::Until:
      return state_without_action(mode, formula.children.back());
    default:
      return std::nullopt;  // there may be another way, or nothing to do
  }
}

}  // namespace

std::optional<Rejection> ruled_out_in(Mode mode, const Formula& goal) {
  const auto state = state_without_action(mode, goal);
  if (!state) return std::nullopt;
  return Rejection{not_in(mode),
                   std::string(name_of(mode)) + " does not offer " + std::string(info(*direct_action(*state)).name) +
                       ", which the goal needs",
                   Failure::NotOffered};
}

std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, ExecutionTree& executions,
                                                      const Demonstration& shown) {
  constexpr std::size_t kLongestRun = 3;
  const auto rejected = [mode](std::string why, Failure failure = Failure::None) {
    return Rejection{not_in(mode), std::move(why), failure};
  };
  const StepLimits limits = rules_of(mode).limits;
  auto plan = actions_of(shown);
  const auto is_offered = [mode](const Action& action) { return offers(info(action.type), mode); };
  const ExpertOptions options{.max_steps = limits.steps, .max_failures = limits.failures, .mode = mode};
  if (!std::all_of(plan.begin(), plan.end(), is_offered)) {
    auto atomic = find_plan(executions, options);
    if (const auto* why = std::get_if<Rejection>(&atomic))
      return rejected(std::string(name_of(why->reason)) + ": " + why->detail, why->failure);
    plan = std::move(std::get<std::vector<Action>>(atomic));
  }

  auto explored = explore(mode, executions, std::move(plan), options);
  if (auto* why = std::get_if<Trouble>(&explored)) return rejected(std::move(why->text), why->failure);
  auto& done = std::get<std::vector<Action>>(explored);
  done.push_back({ActionType::Stop, {}});
  const auto actions = without_needless(executions, mode, std::move(done), kLongestRun);
  if (!actions) return rejected("done so, it does not reach the goal");
  if (static_cast<int>(actions->size()) > limits.steps)
    return rejected("needs " + std::to_string(actions->size()) + " steps");
  return record(executions, mode, *actions);
}

std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, const Formula& goal, const Scene& start,
                                                      const Knowledge& knowledge, const Profile& profile,
                                                      const Demonstration& shown) {
  auto executions = ExecutionTree::of(goal, start, knowledge, profile);
  if (!executions) return Rejection{not_in(mode), format(executions.error())};
  return demonstrate_in(mode, *executions, shown);
}

}  // namespace unietp
