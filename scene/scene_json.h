#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "scene/action.h"
#include "scene/scene.h"
#include "scene/trace.h"

namespace unietp {

/// JSON with `"format": "unietp-scene/1"` as data/schemas/scene.schema.json says; lengths in meters. Numbers are
/// written so that they read back to the same bits, and equal scenes give equal bytes. Hence rotations are unit
/// quaternions [w, x, y, z] and the agent's two angles radians, named `yaw_rad` and `pitch_rad`: not every angle in
/// radians has a number of degrees that turns back into it. All numbers must be finite.
std::string scene_to_json(const Scene& scene);
/// Errors: Parse with line and column for bad JSON; Schema with a JSON pointer for a missing or unknown field, a wrong
/// type, an unknown name, a duplicate id, an edge to nowhere, a size that is not positive. No input makes it throw.
Result<Scene> scene_from_json(std::string_view where, std::string_view text);

/// Checks what the parts alone cannot show: ids are unique, and every id that is referred to exists.
Result<Scene> check_whole(std::string_view where, Scene scene);

/// data/schemas/delta.schema.json and action.schema.json. Empty parts of a delta are left out. Errors: Schema, as
/// above; an action with the wrong number of arguments is one.
std::string delta_to_json(const Delta& delta);
Result<Delta> delta_from_json(std::string_view where, const nlohmann::ordered_json& json);
nlohmann::ordered_json action_to_json(const Action& action);
Result<Action> action_from_json(std::string_view where, const nlohmann::ordered_json& json);

}  // namespace unietp
