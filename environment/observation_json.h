#pragma once

#include <nlohmann/json_fwd.hpp>

#include "environment/observation.h"
#include "environment/settings.h"
#include "environment/step_result.h"

namespace unietp {

/// An observation as JSON (observation_tree.h), its fields always in the same order. Equal observations give equal
/// bytes.
nlohmann::ordered_json observation_to_json(const Observation& observation, const Settings& settings);
/// {"observation", "reward", "terminated", "truncated"}: the public side of a step.
nlohmann::ordered_json step_to_json(const StepResult& step, const Settings& settings);
/// {"success", "hopeless", "progress", "missing", "goal", "steps", "failures", "ended_by"}.
nlohmann::ordered_json privileged_to_json(const PrivilegedState& state);

}  // namespace unietp
