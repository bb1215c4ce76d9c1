#pragma once

#include <vector>

#include "damaged_task.h"

namespace unietp {

/// A way to damage a task and the problem that must be reported.
struct Corruption {
  const char* name;
  const char* kind;              // of the problem that must be reported
  bool (*damage)(DamagedTask&);  // false when the task has nothing that could be damaged this way
};
/// All of them.
extern const std::vector<Corruption> kCorruptions;

}  // namespace unietp
