#pragma once

#include <functional>
#include <string>
#include <vector>

#include "dataset/task.h"

namespace unietp {

/// What a task is in its simulator itself.
struct SimulatorSupport {
  std::vector<std::string> forms;  // that express it (scene/simulator_forms.h)
  std::string refused;             // why it cannot be done there; "" when it can
};
/// What a simulator supports of a task; depends on the task alone. Several threads may call it. A run is given one
/// because exports, which know the simulators' forms, are above it.
using SimulatorCheck = std::function<SimulatorSupport(const Task& task)>;

}  // namespace unietp
