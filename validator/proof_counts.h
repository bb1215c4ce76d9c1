#pragma once

namespace unietp {

/// Numbers of what was checked.
struct ProofCounts {
  int tasks = 0, proven = 0;
  int demonstrations = 0, steps = 0;  // replayed
  int altered_plans = 0;              // changed plans that must fail
  int texts = 0;                      // instructions that were parsed
};

}  // namespace unietp
