#pragma once

#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "resources/resources.h"
#include "sense/evidence.h"

namespace unietp {

/// A place in the data set that one task will fill: what kind it is to be, and which templates may fill it.
struct TaskSlot {
  int index = 0;  // in the data set
  Simulator simulator = Simulator::Ai2thor;
  Split split = Split::Atomic;
  std::vector<std::size_t> templates;  // positions in Resources::templates, ascending; not empty
  std::vector<Grade> least;            // of each of them: what its tasks have to reach, as far as it can at all
  std::size_t first_template = 0;      // position in `templates` of the one that is tried first
};

/// Equal shares for simulators, then for splits, or the quotas asked for. First templates are assigned over the whole
/// data set, each as often as the others as far as its slots allow, in whatever order the slots are filled later.
/// CandidatePlanner decides for each candidate whether to keep the template, and chooses the home and the categories.
/// Deterministic by the configuration's seed. Errors: Usage when a template is unknown, when no template fits a
/// simulator and a split asked for, or when scenes are given and none is of a simulator asked for.
Result<std::vector<TaskSlot>> plan_slots(const RunConfiguration& configuration, const Resources& resources);

}  // namespace unietp
