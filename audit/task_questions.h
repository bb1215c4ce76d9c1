#pragma once

#include "audit/guess.h"
#include "record/dataset_reader.h"

namespace unietp {

/// What the policies are asked about a task, from what an agent is told in each mode that the task has a demonstration
/// of. The options are in the order of the lists; what depends on other homes is left as it is by default
/// (audit/other_homes.h). A question that every option, or none, would answer is not asked.
AuditedTask audited_task(const FinishedTask& task);

}  // namespace unietp
