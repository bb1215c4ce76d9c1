#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "scene/action.h"
#include "scene/scene.h"
#include "scene/trace.h"

namespace unietp {

/// JSON with `"format": "unietp-scene/1"` as data/schemas/scene.schema.json says. Angles in files are degrees, lengths
/// metres. Numbers are written so that they read back to the same bits; equal scenes give equal bytes.
std::string scene_to_json(const Scene& scene);
/// Errors: Parse with line and column for bad JSON; Schema with a JSON pointer for a missing or unknown field, a wrong
/// type, a duplicate id, an edge to nowhere, a size that is not positive.
Result<Scene> scene_from_json(std::string_view where, std::string_view text);

nlohmann::ordered_json delta_to_json(const Delta& delta);
Result<Delta> delta_from_json(std::string_view where, const nlohmann::ordered_json& json);
nlohmann::ordered_json action_to_json(const Action& action);
Result<Action> action_from_json(std::string_view where, const nlohmann::ordered_json& json);

}  // namespace unietp
