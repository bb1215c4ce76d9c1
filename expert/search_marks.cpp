#include "expert/search_marks.h"

#include "expert/rollout.h"

namespace unietp {

bool may_be_search(ActionType type) {
  const ActionClass group = info(type).group;
  return group == ActionClass::Movement || group == ActionClass::Reach || type == ActionType::Open ||
         type == ActionType::Close;
}

void mark_search(ExecutionTree& executions, Demonstration& demonstration) {
  ModeRules told = rules_of(Mode::M1);
  told.limits = rules_of(demonstration.mode).limits;
  Rollout here(executions, told);
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
