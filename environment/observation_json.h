#pragma once

#include <nlohmann/json_fwd.hpp>

#include "environment/observation.h"
#include "environment/settings.h"
#include "environment/step_result.h"

namespace unietp {

/// An observation as JSON, its fields always in the same order (data/schemas/observation.schema.json):
/// {"instruction", "image", "boxes", "rooms", "furniture", "movables", "by_room", "last", "results", "held", "step",
/// "steps_left", "failures_left", "over"}. What the settings do not tell is left out. "image" is {"width", "height"};
/// whoever sends the pixels adds them. Boxes are in the settings' form. Equal observations give equal bytes.
nlohmann::ordered_json observation_to_json(const Observation& observation, const Settings& settings);
/// {"observation", "reward", "terminated", "truncated"}: the public side of a step.
nlohmann::ordered_json step_to_json(const StepResult& step, const Settings& settings);
/// {"success", "hopeless", "progress", "missing", "goal", "steps", "failures", "ended_by"}.
nlohmann::ordered_json privileged_to_json(const PrivilegedState& state);

}  // namespace unietp
