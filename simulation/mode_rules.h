#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/action.h"
#include "scene/scene.h"

namespace unietp {

/// The most steps, and the most failed steps, of an episode. The final `stop` counts.
struct StepLimits {
  int steps = 50, failures = 10;
  bool operator==(const StepLimits&) const = default;
};

/// Where `go_to` takes the agent by id from anywhere: nowhere, into rooms, also to furniture, also to movable objects.
enum class Teleport : std::uint8_t { Nothing, Rooms, Furniture, Anything };

/// How actions of a class name their object: not at all (the class is not offered), by id, or by a box in the picture.
enum class Naming : std::uint8_t { None, Id, Box };

/// What an agent is told and may do: the columns of the paper's table of modes, each of which can be set separately.
struct ModeRules {
  Mode mode = Mode::M1;  // the preset that it began as; refusals name it ("M3 does not offer fill_with.")

  // What the agent is told.
  bool picture = true;  // the camera's image before each step
  bool boxes = true;    // ids, categories and boxes of the objects in view before each step
  bool rooms = true, furniture = true, movables = true;  // lists of the home at the start

  // What it may do.
  Teleport teleport = Teleport::Anything;
  Naming reach = Naming::Id;      // go_to and turn_to an object
  bool move = true;               // small steps of body, camera and hand
  Naming atomic = Naming::Id;     // what the hand does
  Naming composite = Naming::Id;  // heat_with and the like

  StepLimits limits;
  bool invalid_is_free = false;  // actions that do not exist or have wrong arguments are no steps and no failures

  bool operator==(const ModeRules&) const = default;
};
/// The paper's modes. Limits: 50 steps and 10 failures in M1 and M2, 150 and 30 in M3.
ModeRules rules_of(Mode mode);

/// Whether the rules offer an action, in simulators that have it.
bool offers(const ActionInfo& action, const ModeRules& rules);
/// How an action of this kind names an object.
Naming naming_of(const ActionInfo& action, const ModeRules& rules);

/// What an agent knows of a home at the start: rooms, fixed and movable objects, as far as the rules tell of them. Ids
/// in the order of telling_order.
struct GlobalInformation {
  std::vector<std::string> rooms, furniture, movables;
};
/// For the home of `start`.
GlobalInformation global_information(const Scene& start, const ModeRules& rules);

/// In a mode that names objects by boxes, a box refers to the object in the picture whose box has the largest
/// intersection over union with it, if that is more than this.
inline constexpr double kLeastOverlap = 0.1;

}  // namespace unietp
