#include "expert/tempting_plan.h"

#include <algorithm>

#include "expert/execution.h"
#include "expert/rollout.h"
#include "expert/situation.h"
#include "expert/tidying.h"
#include "logic/constraints.h"

namespace unietp {
namespace {

bool reaches(ExecutionTree& executions, const std::vector<Action>& plan) {
  Rollout rollout(executions, rules_of(Mode::M1));
  rollout.go_on(plan);
  return rollout.reaches_goal();
}

bool needs_each_step(ExecutionTree& executions, const std::vector<Action>& plan) {
  for (std::size_t i = 0; i + 1 < plan.size(); ++i) {
    auto without = plan;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    if (reaches(executions, without)) return false;
  }
  return true;
}

/// The expert's plan for a hasty reading of the goal, if it reaches what was asked, needs each step for that, and
/// breaks the goal.
std::vector<Action> plan_for(const Formula& hasty, const Formula& asked, const ExecutionTree& executions,
                             const ExpertOptions& options) {
  ExecutionTree branch = executions.with_goal(hasty);
  auto found = find_plan(branch, options);
  auto* plan = std::get_if<std::vector<Action>>(&found);
  const std::size_t least = 2;  // something is done before `stop`
  if (plan == nullptr || plan->size() < least || plan->size() > static_cast<std::size_t>(options.max_steps)) return {};
  ExecutionTree constrained = branch.with_goal(executions.goal()), relaxed = branch.with_goal(asked);
  if (reaches(constrained, *plan) || !reaches(relaxed, *plan) || !needs_each_step(relaxed, *plan)) return {};
  return std::move(*plan);
}

bool reaches_reading(const ExecutionTree& executions, const HastyReading& reading, const std::vector<Action>& plan) {
  ExecutionTree of_reading = executions.with_goal(reading.goal);
  return reaches(of_reading, plan);
}

}  // namespace

std::vector<Action> tempting_plan(const ExecutionTree& executions, const Demonstration& shown) {
  const Formula& goal = executions.goal();
  const std::vector<HastyReading> readings = hasty_readings(goal);
  if (readings.empty()) return {};
  const Formula& asked = readings.front().goal;
  const std::vector<Action> done = actions_for_the_goal(shown);
  ExpertOptions no_longer;
  no_longer.max_steps = static_cast<int>(done.size());
  for (const Formula& one : with_an_order_reversed(goal)) {
    if (auto plan = plan_for(one, asked, executions, no_longer); !plan.empty()) return plan;
  }
  for (const HastyReading& reading : readings) {
    if (reading.takes_more && reaches_reading(executions, reading, done)) continue;  // it does not do more
    auto plan = plan_for(reading.goal, reading.goal, executions, no_longer);
    if (!plan.empty()) return plan;
  }
  return {};
}

std::optional<Rejection> add_tempting_plan(Demonstration& demonstration, const ExecutionTree& executions) {
  if (hasty_readings(executions.goal()).empty()) return std::nullopt;
  demonstration.tempting = tempting_plan(executions, demonstration);
  if (demonstration.tempting.empty()) return Rejection{RejectionReason::NotTempting, to_text(executions.goal())};
  return std::nullopt;
}

}  // namespace unietp
