#pragma once

#include <vector>

#include "core/result.h"
#include "exports/finished_tasks.h"

namespace unietp {

/// A demonstration with mistakes in it.
struct MistakenDemonstration {
  DemonstrationRecord shown;   // every step with its real outcome and view
  std::vector<bool> mistakes;  // which steps are wrong actions, not steps of the demonstration or of a recovery
};

/// Puts a plausible wrong action before a step with the probability `rate`, as an agent might try: a later action too
/// early (from too far away, with full or empty hands, on something closed), which fails and changes nothing, or, in M1
/// and M2, another thing picked up, which is put back where it was. All is executed, so feedback and views are real,
/// and the goal still holds at the end; within the limits of the mode. Where no such action is found, or what was put
/// back keeps the rest from working, the demonstration stays as it is. `task` must have a demonstration of `mode`.
/// Depends on the task, the mode and the rate alone. Errors: Schema for a start that cannot be built.
Result<MistakenDemonstration> with_mistakes(const FinishedTask& task, Mode mode, const ValidationBackend& backend,
                                            double rate);

}  // namespace unietp
