#pragma once

#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "generator/rejection.h"
#include "run/make_task.h"

namespace unietp {

/// How long a trial runs.
struct TrialOptions {
  int tries = 10;                           // candidates
  int enough = 0;                           // proven tasks after which no further one is tried; 0: all tries are made
  const std::atomic<bool>* stop = nullptr;  // set from outside: end before the next candidate
};

/// The tasks and rejections of candidates of one template on one simulator.
struct TemplateTrial {
  int candidates = 0;
  std::vector<Task> tasks;  // the proven ones, in order of attempt
  struct Reason {
    RejectionReason reason = RejectionReason::NoPlan;
    int count = 0;
    std::string example;                    // the detail of the first of them
    std::vector<std::string> details = {};  // of all of them, in order of attempt
    std::map<Failure, int> failures = {};   // of the actions that the expert could not do, with how often; without None
  };
  std::vector<Reason> reasons;  // why the others were rejected; the most frequent first, then by name
};

/// Takes candidates of one template through all stages: candidate k in the k-th home of the pool, starting over after
/// the last. `configuration` names the seed. Deterministic: the candidates depend on the seed, the homes, the
/// template and the simulator, not on the other templates.
TemplateTrial try_template(const RunConfiguration& configuration, const Resources& resources, LayoutPool& layouts,
                           std::size_t position, Simulator simulator, const TrialOptions& options);

}  // namespace unietp
