#pragma once

#include <variant>

#include "dataset/task.h"
#include "run/candidate_planner.h"
#include "run/slots.h"
#include "run/stage_costs.h"

namespace unietp {

/// The whole path of one candidate: template and binding → specification → refinement → episode → demonstration →
/// must-fail mutations → instruction. Deterministic in (configuration, resources, slot, plan, counts); `costs` may be
/// null. `counts`: how often categories were used, for a binding that has to be drawn anew because no refinement
/// applies to it.
std::variant<Task, RejectedCandidate> make_task(const RunConfiguration& configuration, const Resources& resources,
                                                LayoutPool& layouts, const TaskSlot& slot, const CandidatePlan& plan,
                                                const Frequencies& counts, StageCosts* costs);

}  // namespace unietp
