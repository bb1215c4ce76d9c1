#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "scene/action.h"
#include "scene/pixel_box.h"

namespace unietp {

/// How an agent names an object or a room: by id, or in M3 an object by the box around it in the picture.
struct Argument {
  std::string id;               // "" when a box is given
  std::optional<PixelBox> box;  // pixels
  bool operator==(const Argument&) const = default;
};

/// One step as an agent says it, before the rules of its mode have made it an action: the name may be of no action and
/// the arguments of nothing.
struct Command {
  std::string action;
  std::vector<Argument> args;
  bool operator==(const Command&) const = default;
};
/// The same action with its objects named by ids.
Command by_ids(const Action& action);
std::string to_text(const Command& command);  // "pick_up(mug_1)", "pick_up([10, 20, 30, 40])"

/// `{"action": "pick_up", "args": ["mug_1"]}`; a box is `{"bbox": [10, 20, 30, 40]}` (data/schemas/action.schema.json).
nlohmann::ordered_json command_to_json(const Command& command);
/// Errors: Schema with a JSON pointer for a missing, unknown or mistyped field. Whether there is such an action, and
/// how many arguments it takes, is not asked here.
Result<Command> command_from_json(std::string_view where, const nlohmann::ordered_json& json);

}  // namespace unietp
