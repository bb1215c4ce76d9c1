#pragma once

#include <memory>

#include "core/result.h"
#include "environment/simulator_answer.h"
#include "environment/task.h"
#include "scene/action.h"

namespace unietp {

/// A simulator of somebody else in which an episode is acted out, beside our physics, which decide what the agent sees.
/// An action has to succeed in both; the goal is judged on the simulator's state. One episode at a time.
class ActingSimulator {
 public:
  virtual ~ActingSimulator() = default;
  /// Brings the start of a task about. Errors: what went wrong, which is not the agent's doing.
  virtual Result<Done> begin(const EnvironmentTask& task) = 0;
  /// Executes an action that our physics allow. `now`: its state, in our scene graph. `ours`: what the action changed
  /// in our physics. Errors: as begin.
  virtual Result<SimulatorAnswer> act(const Action& action, const Scene& now, const Delta& ours) = 0;
};
using SharedSimulator = std::shared_ptr<ActingSimulator>;  // by the states of one environment

}  // namespace unietp
