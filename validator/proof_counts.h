#pragma once

namespace unietp {

/// What was proven how often.
struct ProofCounts {
  int tasks = 0, proven = 0;
  int demonstrations = 0, steps = 0;  // replayed
  int spoilt_plans = 0;               // that must fail
  int texts = 0;                      // read
};

}  // namespace unietp
