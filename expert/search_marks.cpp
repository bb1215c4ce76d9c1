#include "expert/search_marks.h"

#include "expert/rollout.h"

namespace unietp {

bool may_be_search(ActionType type) {
  const ActionClass group = info(type).group;
  return group == ActionClass::Movement || group == ActionClass::Reach || type == ActionType::Open ||
         type == ActionType::Close;
}

ModeRules rules_with_full_knowledge(std::size_t steps) {
  ModeRules told = rules_of(Mode::M1);
  told.limits.steps = told.limits.failures = static_cast<int>(steps) + 1;
  return told;
}

void mark_search(ExecutionTree& executions, Demonstration& demonstration) {
  Rollout here(executions, rules_with_full_knowledge(demonstration.steps.size()));
  for (auto step = demonstration.steps.begin(); step != demonstration.steps.end(); ++step) {
    if (!step->tidying && may_be_search(step->action.type)) {
      Rollout without = here;
      for (auto later = std::next(step); later != demonstration.steps.end(); ++later)
        (void)without.go_on(later->action);
      step->search = without.reaches_goal();
    }
    (void)here.go_on(step->action);
  }
}

}  // namespace unietp
