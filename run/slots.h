#pragma once

#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "resources/resources.h"
#include "run/task_slot.h"

namespace unietp {

/// Equal shares for simulators, then for splits, or the quotas asked for. First templates are assigned over the whole
/// data set, each as often as the others as far as its slots allow, in whatever order the slots are filled later; in
/// the Linguistic split phenomena are (styles_of_slots.h), and each slot's template fits its first. CandidatePlanner
/// decides for each candidate whether to keep the template, and chooses the home and the categories. Deterministic by
/// the configuration's seed. Errors: Usage when a template is unknown, when no template fits a simulator and a split
/// asked for, or when scenes are given and none is of a simulator asked for.
Result<std::vector<TaskSlot>> plan_slots(const RunConfiguration& configuration, const Resources& resources);

}  // namespace unietp
