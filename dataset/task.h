#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "annotator/instruction.h"
#include "dataset/balance.h"
#include "dataset/task_purpose.h"
#include "expert/demonstration.h"
#include "generator/rejection.h"
#include "grounding/episode.h"
#include "sense/grade_goal.h"

namespace unietp {

/// One finished task: an episode with its demonstration and its instruction.
struct Task {
  std::string id;  // "ai2thor-00003"
  Episode episode;
  Demonstration demonstration;                // mode M1
  std::vector<Demonstration> in_other_modes;  // in the order of the configuration
  Instruction instruction;
  TaskPurpose purpose;
  TaskSense sense;
  std::vector<Trait> traits;  // its values in the balanced dimensions
  std::uint64_t seed = 0;     // of the run
  int slot = 0, attempt = 0;
  std::vector<std::string> forms = {};  // of its simulator that express it (scene/simulator_forms.h)
};

/// A rejected candidate, with the properties that the task would have had.
struct RejectedCandidate {
  Rejection rejection;
  std::string template_name;
  Simulator simulator = Simulator::Ai2thor;
  Split split = Split::Atomic;
  int slot = 0, attempt = 0;
};

}  // namespace unietp
