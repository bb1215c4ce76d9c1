#pragma once

#include <string>
#include <vector>

#include "scene/action.h"
#include "scene/scene.h"

namespace unietp {

/// The most steps, and the most failed steps, of an episode. The final `stop` counts.
struct StepLimits {
  int steps = 50, failures = 10;
};
/// The paper's: 50 and 10 in M1 and M2, 150 and 30 in M3.
StepLimits limits_of(Mode mode);

/// What an agent of a mode knows of a home at the start: all rooms; in M1 and M2 the fixed objects; in M1 also the
/// movable ones. Ids in the order of the scene.
struct GlobalInformation {
  std::vector<std::string> rooms, furniture, movables;
};
/// For the home of `start`.
GlobalInformation global_information(const Scene& start, Mode mode);

/// Whether an agent of the mode is told the boxes and ids of the objects that it sees; in M3 it gets only the picture.
bool tells_boxes(Mode mode);

/// In M3 a box refers to the object in the picture whose box has the largest intersection over union with it, if that
/// is more than this.
inline constexpr double kLeastOverlap = 0.1;

}  // namespace unietp
