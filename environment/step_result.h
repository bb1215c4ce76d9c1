#pragma once

#include <optional>
#include <string>
#include <vector>

#include "environment/observation.h"
#include "environment/simulator_answer.h"
#include "scene/command.h"
#include "scene/trace.h"
#include "simulation/outcome.h"

namespace unietp {

/// What one executed action came to, for programs: not part of what the agent is told.
struct ExecutedAction {
  Command command;                  // as the mode took it; empty for an answer that could not be read
  Outcome outcome;                  // success, kind of failure, the sentence of the mode, whatever `feedback` is set to
  Delta changes;                    // of the scene that the goal is judged on
  bool counted = true;              // as a step; an invalid action is not when those are free
  std::vector<Delta> moments = {};  // the changes from moment to moment, where it passed through several; else empty
  std::optional<SimulatorAnswer> simulator = {};  // what it said, where there is one and it was asked
};

/// What a step gives.
struct StepResult {
  Observation observation;
  double reward = 0;                     // see Reward
  bool terminated = false;               // by `stop` or the limit of failures
  bool truncated = false;                // by the limit of steps or of answers
  std::vector<ExecutedAction> executed;  // privileged
};

/// The privileged side: nothing of it is shown to an agent.
struct PrivilegedState {
  bool success = false;   // the goal would hold if the episode ended now; the verdict when it is over
  bool hopeless = false;  // no continuation can reach the goal (sound, not complete)
  double progress = 0;    // in [0, 1], the share of the goal's parts that are met; 1 exactly with success
  std::string missing;    // a sentence with ids; "" with success
  std::string goal;       // the formula's text
  int steps = 0, failures = 0;
  std::string ended_by;  // "", "stop", "steps", "failures" or "answers"
};

}  // namespace unietp
