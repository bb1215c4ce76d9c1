#pragma once

#include <functional>
#include <string>

#include "dataset/candidate.h"
#include "dataset/task.h"

namespace unietp {

/// Why a task cannot be done in its simulator itself; "" when it can. Depends on the task alone. Several threads may
/// call it. A run is given one because exports, which know the simulators' forms, are above it.
using NotNative = std::function<std::string(const Task& task, const WrittenTask& written)>;

}  // namespace unietp
