#pragma once

#include <vector>

#include "audit/guess.h"

namespace unietp {

/// Fills in what depends on other homes: the ranks, `elsewhere`, the shares. Other homes are those of `examples` with
/// another name than the task's own, each as its first task has it at the start; tasks are all that are in them.
void compare_with_other_homes(std::vector<AuditedTask>& tasks, const std::vector<AuditedTask>& examples);

}  // namespace unietp
