#pragma once

#include <vector>

#include "core/result.h"
#include "pipeline/configuration.h"
#include "pipeline/resources.h"

namespace unietp {

/// A place in the data set that one task will fill: what kind it is to be, and which templates may fill it.
struct TaskSlot {
  int index = 0;  // in the data set
  Simulator simulator = Simulator::Ai2thor;
  Split split = Split::Atomic;
  int number = 0;                      // among the slots of its simulator
  std::vector<std::size_t> templates;  // positions in Resources::templates, the preferred one first; not empty

  /// A candidate keeps its template for a few attempts, then the next one is tried.
  static constexpr int kAttemptsPerTemplate = 3;
  std::size_t template_for(int attempt) const {
    return templates[static_cast<std::size_t>(attempt / kAttemptsPerTemplate) % templates.size()];
  }
};

/// Homes made for each simulator: a few tasks share one, so that building homes does not dominate a run.
int layouts_per_simulator(const RunConfiguration& configuration);

/// Equal shares for simulators, then for splits, then round robin over templates in an order drawn from the seed.
/// Deterministic. Errors: Usage when a template is unknown, when no template fits a simulator
/// and a split asked for, or when scenes are given and none is of a simulator asked for.
Result<std::vector<TaskSlot>> plan_slots(const RunConfiguration& configuration, const Resources& resources);

}  // namespace unietp
