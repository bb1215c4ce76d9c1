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
  if (plan == nullptr || plan->size() > static_cast<std::size_t>(options.max_steps)) return {};
  ExecutionTree constrained = branch.with_goal(executions.goal()), relaxed = branch.with_goal(asked);
  if (reaches(constrained, *plan) || !reaches(relaxed, *plan) || !needs_each_step(relaxed, *plan)) return {};
  return std::move(*plan);
}

}  // namespace

std::vector<Action> tempting_plan(const ExecutionTree& executions, const Demonstration& shown) {
  const Formula& goal = executions.goal();
  if (!constrains_the_way(goal)) return {};
  const Formula asked = without_constraints(goal);
  ExpertOptions no_longer;
  const std::vector<Action> done = actions_for_the_goal(shown);
  no_longer.max_steps = static_cast<int>(done.size());
  std::vector<Formula> hasty = with_an_order_reversed(goal);
  hasty.push_back(asked);
  for (const Formula& one : hasty) {
    if (auto plan = plan_for(one, asked, executions, no_longer); !plan.empty()) return plan;
  }
  if (!has_operator(goal, {Formula::Op::Always})) return {};
  const Formula all = without_references(asked);
  ExecutionTree of_all = executions.with_goal(all);
  if (reaches(of_all, done)) return {};  // nothing is left out
  auto plan = plan_for(all, all, executions, {});
  return plan.size() > done.size() ? plan : std::vector<Action>();  // a shorter one has to reach what was asked
}

std::optional<Rejection> add_tempting_plan(Demonstration& demonstration, const ExecutionTree& executions) {
  if (!constrains_the_way(executions.goal())) return std::nullopt;
  demonstration.tempting = tempting_plan(executions, demonstration);
  if (demonstration.tempting.empty()) return Rejection{RejectionReason::NotTempting, to_text(executions.goal())};
  return std::nullopt;
}

}  // namespace unietp
