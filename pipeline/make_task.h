#pragma once

#include <string>
#include <variant>

#include "annotator/instruction.h"
#include "expert/expert.h"
#include "grounding/episode.h"
#include "pipeline/candidate_planner.h"
#include "pipeline/resources.h"
#include "pipeline/slots.h"
#include "pipeline/stage_costs.h"

namespace unietp {

/// One finished task: an episode with its demonstration and its instruction.
struct Task {
  std::string id;  // "ai2thor-00003"
  Episode episode;
  Demonstration demonstration;                // mode M1
  std::vector<Demonstration> in_other_modes;  // in the order of the configuration
  Instruction instruction;
  std::vector<Trait> traits;  // what it is among the tasks of a data set
  std::uint64_t seed = 0;     // of the run
  int slot = 0, attempt = 0;
};

/// A candidate that was given up, with what it was going to be.
struct RejectedCandidate {
  Rejection rejection;
  std::string template_name;
  Simulator simulator = Simulator::Ai2thor;
  Split split = Split::Atomic;
  int slot = 0, attempt = 0;
};

/// The whole path of one candidate: template and binding → specification → refinement → episode → demonstration →
/// must-fail mutations → instruction. Deterministic in (configuration, resources, slot, plan, counts); `costs` may be
/// null. `counts`: how often categories were used, for a binding that has to be drawn anew because no refinement
/// applies to it.
std::variant<Task, RejectedCandidate> make_task(const RunConfiguration& configuration, const Resources& resources,
                                                LayoutPool& layouts, const TaskSlot& slot, const CandidatePlan& plan,
                                                const Frequencies& counts, StageCosts* costs);

}  // namespace unietp
