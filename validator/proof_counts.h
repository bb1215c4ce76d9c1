#pragma once

namespace unietp {

/// Numbers of what was checked.
struct ProofCounts {
  int tasks = 0, proven = 0;
  int demonstrations = 0, steps = 0;  // replayed
  int altered_plans = 0;              // changed plans that must fail
  int constrained = 0, tempting = 0;  // tasks whose goal has a constraint; those of them of which such a plan breaks it
  int texts = 0;                      // instructions that were parsed
  int unchecked = 0;  // tasks with a person's text that failed the checks: their goal may be proven, their text is not
};

}  // namespace unietp
