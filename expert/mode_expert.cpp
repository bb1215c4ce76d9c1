#include "expert/mode_expert.h"

#include <algorithm>
#include <utility>

#include "expert/belief_expert.h"
#include "expert/execution.h"
#include "expert/search_marks.h"
#include "expert/tidying.h"

namespace unietp {
namespace {

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

/// With the actions that the mode offers, of one who knows where everything is.
std::variant<std::vector<Action>, Rejection> plan_of_who_knows(Mode mode, ExecutionTree& executions,
                                                               const Demonstration& shown,
                                                               const ExpertOptions& options) {
  auto plan = actions_for_the_goal(shown);
  const auto is_offered = [mode](const Action& action) { return offers(info(action.type), mode); };
  if (std::all_of(plan.begin(), plan.end(), is_offered)) return plan;
  return find_plan(executions, options);
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

std::variant<std::vector<Action>, Rejection> act_by_belief(Mode mode, ExecutionTree& executions,
                                                           const Household* usual) {
  const auto rejected = [mode](Trouble why) { return Rejection{not_in(mode), std::move(why.text), why.failure}; };
  EpisodeWindow window(executions, mode);
  const SearchProblem problem{executions.goal(), executions.knowledge(), executions.profile(), usual, mode};
  if (auto why = reach_by_belief(problem, window)) return rejected(std::move(*why));
  if (!window.reaches_goal()) return rejected({"done by what was seen, it does not reach the goal"});
  return window.done();
}

std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, ExecutionTree& executions, const Demonstration& shown,
                                                      const Household* usual, std::vector<Action> done) {
  const StepLimits limits = rules_of(mode).limits;
  const ExpertOptions options{.max_steps = limits.steps, .max_failures = limits.failures, .mode = mode};
  auto known = plan_of_who_knows(mode, executions, shown, options);
  if (const auto* why = std::get_if<Rejection>(&known))
    return Rejection{not_in(mode), std::string(name_of(why->reason)) + ": " + why->detail, why->failure};
  auto& shortest = std::get<std::vector<Action>>(known);
  if (done.empty()) {
    auto acted = act_by_belief(mode, executions, usual);
    if (auto* why = std::get_if<Rejection>(&acted)) return std::move(*why);
    done = std::move(std::get<std::vector<Action>>(acted));
  }
  Demonstration demonstration = record(executions, mode, done);
  mark_tidying(executions, demonstration);
  mark_search(executions, demonstration);
  done = actions_for_the_goal(demonstration);
  if (shortest.size() > done.size()) {
    auto needed = without_needless(executions, rules_of(Mode::M1), std::move(done), 1);
    if (needed) shortest = std::move(*needed);
  }
  demonstration.shortest = std::move(shortest);
  return demonstration;
}

std::variant<Demonstration, Rejection> demonstrate_in(Mode mode, const Formula& goal, const Scene& start,
                                                      const Knowledge& knowledge, const Profile& profile,
                                                      const Demonstration& shown) {
  auto executions = ExecutionTree::of(goal, start, knowledge, profile);
  if (!executions) return Rejection{not_in(mode), format(executions.error())};
  return demonstrate_in(mode, *executions, shown);
}

}  // namespace unietp
