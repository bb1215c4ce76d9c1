#pragma once

#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "resources/resources.h"

namespace unietp {

/// A place in the data set that one task will fill: what kind it is to be, and which templates may fill it.
struct TaskSlot {
  int index = 0;  // in the data set
  Simulator simulator = Simulator::Ai2thor;
  Split split = Split::Atomic;
  std::vector<std::size_t> templates;  // positions in Resources::templates, ascending; not empty
  std::size_t dealt = 0;               // position in `templates` of the one to begin with
};

/// Equal shares for simulators, then for splits, or the quotas asked for. Templates are dealt out over the whole data
/// set, so that each is begun with as often as the others wherever its slots allow, however the slots are then worked
/// through; whether it can stay, in which home and with which categories is settled candidate by candidate
/// (candidate_planner.h). Deterministic by the configuration's seed. Errors: Usage when a template is unknown, when no
/// template fits a simulator and a split asked for, or when scenes are given and none is of a simulator asked for.
Result<std::vector<TaskSlot>> plan_slots(const RunConfiguration& configuration, const Resources& resources);

}  // namespace unietp
