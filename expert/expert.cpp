#include "expert/expert.h"

#include <array>
#include <map>
#include <set>

#include "expert/attempt.h"
#include "expert/execution.h"
#include "expert/goal_reading.h"
#include "expert/least_steps.h"
#include "expert/methods.h"
#include "expert/ordering.h"
#include "expert/parking.h"
#include "expert/plan_cost.h"
#include "expert/tidying.h"
#include "logic/monitor.h"

namespace unietp {
namespace {

constexpr std::array kOrderPreferences{
    OrderPreferences{}, OrderPreferences{.switch_before_placing = true}, OrderPreferences{.far_first = true},
    OrderPreferences{.far_first = true, .switch_before_placing = true}, OrderPreferences{.large_first = true}};
constexpr double kPerPreference = 2;    // penalty for each departure from the usual preferences, in actions
constexpr double kFailedLiteral = 100;  // surcharges that a failure teaches, in actions
constexpr double kFailedThing = 30;
constexpr int kTriesPerLiteral = 3;  // a truth that later steps keep undoing is given up after so many

constexpr int kCompared = 6;         // further choices that are carried out once one works, the most promising first
constexpr double kMostCostlier = 6;  // choices estimated to take more than these further actions are not compared
constexpr int kMostActions = 3;      // times the steps of a plan: what fails after so many is given up
constexpr int kMostOutOfSteps = 3;   // attempts; what asks for so much is not met by another order

struct Choice {
  Alternative alternative;
  OrderPreferences preferences;
  double cost = 0;  // estimated, in actions
};

/// The cheapest choice that was not tried yet.
std::optional<Choice> next_choice(const std::vector<Alternative>& alternatives, const Situation& situation,
                                  std::set<std::string>& tried) {
  const Alternative* best = nullptr;
  std::size_t best_preferences = 0;
  double best_cost = 0;
  std::string best_name;
  for (const Alternative& alternative : alternatives) {
    const std::string text = changes_text(alternative, situation);
    for (std::size_t h = 0; h < kOrderPreferences.size(); ++h) {
      const double cost = alternative.cost + kPerPreference * static_cast<double>(h);
      std::string name = std::to_string(h) + " " + text;
      if ((best != nullptr && cost >= best_cost) || tried.contains(name)) continue;
      best = &alternative;
      best_preferences = h;
      best_cost = cost;
      best_name = std::move(name);
    }
  }
  if (best == nullptr) return std::nullopt;
  tried.insert(best_name);
  return Choice{*best, kOrderPreferences[best_preferences], best_cost};
}

/// Brings all the literals about so that they hold together; gives the one that failed.
std::optional<Literal> bring_about(Attempt& attempt, Methods& methods, const std::vector<Literal>& literals,
                                   const OrderPreferences& preferences) {
  std::map<Literal, int> tries;
  while (auto literal = next_literal(attempt, literals, preferences)) {
    if (++tries[*literal] > kTriesPerLiteral) return literal;
    if (!methods.achieve(*literal)) return literal;
  }
  return std::nullopt;
}

/// Moments in order, then the end. Gives the literal that failed.
std::optional<Literal> carry_out(Attempt& attempt, Methods& methods, const OrderPreferences& preferences) {
  const Alternative& alternative = attempt.alternative();
  for (const std::size_t moment : order_of_moments(alternative, preferences)) {
    if (attempt.has_come(moment)) continue;
    if (auto failed = bring_about(attempt, methods, alternative.moments[moment].literals, preferences)) return failed;
  }
  return bring_about(attempt, methods, wanted_at_end(alternative), preferences);
}

void shun(CostPenalties& experience, const Situation& situation, const std::string& id) {
  if (const auto entity = situation.find(id)) experience.things.emplace_back(*entity, kFailedThing);
}

void learn(CostPenalties& experience, const Situation& situation, const Attempt& attempt, const Literal& failed) {
  experience.literals.emplace_back(failed, kFailedLiteral);
  if (situation.is_imagined(failed.subject)) {
    experience.things.emplace_back(situation.slice(failed.subject).whole, kFailedThing);
  }
  if (!attempt.trouble()) return;
  for (const std::string& id : attempt.trouble()->action.args) shun(experience, situation, id);
}

std::string missing_after(ExecutionTree& executions, const std::vector<Action>& actions) {
  Monitor monitor(executions.goal());
  World world = executions.world();
  monitor.observe(executions.entities(), executions.facts(world));
  for (const Action& action : actions) {
    if (!executions.step(world, action).success) continue;
    for (const PassedMoment& passed : world.passed())
      monitor.observe(executions.entities(), executions.facts(passed.moment));
    monitor.observe(executions.entities(), executions.facts(world));
  }
  return monitor.missing();
}

/// Of a plan, what it needs; nullopt when it misses the goal.
std::optional<std::vector<Action>> needed_of(ExecutionTree& executions, const Attempt& attempt,
                                             std::vector<Action> actions) {
  // Only an attempt that had to change its mind leaves detours longer than a step.
  return without_needless(executions, rules_of(Mode::M1), std::move(actions), attempt.failures() == 0 ? 1 : 6);
}

/// Much was still to be done: another order saves a step here and there.
bool was_far(const Attempt& attempt) {
  const auto& end = attempt.alternative().end;
  const auto open =
      std::count_if(end.begin(), end.end(), [&](const Literal& literal) { return !attempt.holds(literal); });
  return 4 * open > std::ssize(end);
}

/// The choices that are left over once a plan works, compared with it.
class CheapestPlan {
 public:
  CheapestPlan(ExecutionTree& executions, const Situation& situation, const ExecutedPrefix& beginning,
               const ExpertOptions& options, bool clears, std::vector<Action> plan)
      : executions_(executions),
        situation_(situation),
        beginning_(beginning),
        options_(options),
        clears_(clears),
        best_(std::move(plan)),
        cost_(cost_of(executions, best_)) {}

  /// Carries a choice out as far as it can still be cheaper, and keeps it if it is.
  void add(const Choice& choice) {
    ExpertOptions no_longer = options_;
    no_longer.max_steps = std::min(options_.max_steps, cost_.steps);
    Attempt attempt(executions_, situation_, choice.alternative, no_longer);
    for (const Action& action : beginning_.done) attempt.act(action);
    if (attempt.actions().size() != beginning_.done.size()) return;
    if (attempt.actions().size() + least_steps(attempt) + 1 > static_cast<std::size_t>(no_longer.max_steps)) return;
    Methods methods(attempt, categories_of(executions_.goal()), beginning_.avoided, clears_);
    if (carry_out(attempt, methods, choice.preferences)) return;
    std::vector<Action> actions = attempt.actions();
    actions.push_back(Action{ActionType::Stop, {}});
    if (cost_of(executions_, actions) >= cost_) return;
    auto needed = beginning_.done.empty() ? needed_of(executions_, attempt, actions) : std::optional(actions);
    if (!needed) return;
    best_ = std::move(*needed);
    cost_ = cost_of(executions_, best_);
  }

  const std::vector<Action>& best() const { return best_; }

 private:
  ExecutionTree& executions_;
  const Situation& situation_;
  const ExecutedPrefix& beginning_;
  const ExpertOptions& options_;
  bool clears_;
  std::vector<Action> best_;
  PlanCost cost_;
};

/// `lacked_room` becomes true when something failed for want of it.
std::variant<std::vector<Action>, Rejection> try_plans(ExecutionTree& executions, const Situation& situation,
                                                       const ExecutedPrefix& beginning, const ExpertOptions& options,
                                                       bool clears, int compared, bool& lacked_room) {
  const Formula& goal = executions.goal();
  CostPenalties experience;
  for (const std::string& id : beginning.avoided) shun(experience, situation, id);
  std::set<std::string> tried;
  Rejection last{RejectionReason::NoPlan, "no way to meet the goal with what the scene has: " + to_text(goal)};
  int out_of_steps = 0, actions_done = 0;
  for (int plan = 0; plan < options.max_plans; ++plan) {
    if (out_of_steps >= kMostOutOfSteps || actions_done >= kMostActions * options.max_steps) break;
    const auto alternatives = read_goal(goal, situation, experience);
    const auto choice = next_choice(alternatives, situation, tried);
    if (!choice) break;
    Attempt attempt(executions, situation, choice->alternative, options);
    for (const Action& action : beginning.done) attempt.act(action);
    // What was done in a home need not work in the home that is believed.
    if (attempt.actions().size() != beginning.done.size())
      return Rejection{RejectionReason::NoPlan, "what was done does not fit what is believed of the home"};
    const std::size_t least = attempt.actions().size() + least_steps(attempt) + 1;
    if (least > static_cast<std::size_t>(options.max_steps)) {
      ++out_of_steps;
      last = {RejectionReason::TooManySteps, "needs " + std::to_string(least) + " steps or more, and " +
                                                 std::to_string(options.max_steps) + " are allowed"};
      continue;
    }
    Methods methods(attempt, categories_of(goal), beginning.avoided, clears);
    const auto failed = carry_out(attempt, methods, choice->preferences);
    actions_done += static_cast<int>(std::ssize(attempt.actions()) - std::ssize(beginning.done)) + attempt.failures();
    if (failed) {
      lacked_room = lacked_room || Methods::lacked_room(attempt);
      learn(experience, situation, attempt, *failed);
      const std::string aim = to_text(*failed, situation);
      if (attempt.trouble()) {
        if (attempt.trouble()->reason == RejectionReason::TooManySteps)
          out_of_steps += was_far(attempt) ? kMostOutOfSteps : 1;
        last = {attempt.trouble()->reason, "for " + aim + ": " + attempt.trouble()->text, attempt.trouble()->failure};
      } else {
        last = {RejectionReason::ActionFailed, "no way to " + aim};
      }
      continue;
    }
    std::vector<Action> actions = attempt.actions();
    actions.push_back(Action{ActionType::Stop, {}});
    auto needed = beginning.done.empty() ? needed_of(executions, attempt, actions) : std::optional(actions);
    if (needed && compared == 0)
      return std::vector(needed->begin() + static_cast<std::ptrdiff_t>(beginning.done.size()), needed->end());
    if (needed) {
      CheapestPlan cheapest(executions, situation, beginning, options, clears, std::move(*needed));
      for (int i = 0; i < compared; ++i) {
        const auto other = next_choice(alternatives, situation, tried);
        if (!other || other->cost > choice->cost + kMostCostlier) break;
        cheapest.add(*other);
      }
      const auto best = without_parking(executions, cheapest.best(), beginning.done.size());
      return std::vector(best.begin() + static_cast<std::ptrdiff_t>(beginning.done.size()), best.end());
    }
    last = {RejectionReason::GoalNotMet, missing_after(executions, actions)};
    for (const Literal& literal : choice->alternative.end) experience.literals.emplace_back(literal, 1.0);
  }
  return last;
}

/// The cheapest of the first plan that works and so many others.
std::variant<std::vector<Action>, Rejection> find_cheapest(ExecutionTree& executions, const ExecutedPrefix& beginning,
                                                           const ExpertOptions& options, int compared) {
  const Situation situation = look_around(executions, options.mode);
  bool lacked_room = false;
  auto plan = try_plans(executions, situation, beginning, options, beginning.clears, compared, lacked_room);
  // What is in the way is carried away only where no other witness, place or tool will do.
  if (!beginning.clears && lacked_room && std::holds_alternative<Rejection>(plan))
    plan = try_plans(executions, situation, beginning, options, true, compared, lacked_room);
  return plan;
}

}  // namespace

std::variant<std::vector<Action>, Rejection> find_plan_from(ExecutionTree& executions, const ExecutedPrefix& beginning,
                                                            const ExpertOptions& options) {
  return find_cheapest(executions, beginning, options, 0);
}

std::variant<std::vector<Action>, Rejection> find_cheapest_plan_from(ExecutionTree& executions,
                                                                     const ExecutedPrefix& beginning,
                                                                     const ExpertOptions& options) {
  return find_cheapest(executions, beginning, options, kCompared);
}

std::variant<std::vector<Action>, Rejection> find_plan(ExecutionTree& executions, const ExpertOptions& options) {
  return find_plan_from(executions, {}, options);
}

std::variant<Demonstration, Rejection> demonstrate(ExecutionTree& executions, const ExpertOptions& options) {
  auto plan = find_cheapest_plan_from(executions, {}, options);
  if (auto* why = std::get_if<Rejection>(&plan)) return std::move(*why);
  Demonstration demonstration = record(
      executions, Mode::M1, tidied(executions, rules_of(Mode::M1), std::get<std::vector<Action>>(std::move(plan))));
  mark_tidying(executions, demonstration);
  return demonstration;
}

std::variant<Demonstration, Rejection> demonstrate(const Formula& goal, const Scene& start, const Knowledge& knowledge,
                                                   const Profile& profile, const ExpertOptions& options) {
  auto executions = ExecutionTree::of(goal, start, knowledge, profile);
  if (!executions) return Rejection{RejectionReason::NoPlan, format(executions.error())};
  return demonstrate(*executions, options);
}

}  // namespace unietp
