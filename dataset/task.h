#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "annotator/instruction.h"
#include "dataset/balance.h"
#include "expert/demonstration.h"
#include "generator/rejection.h"
#include "grounding/episode.h"

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

}  // namespace unietp
