#pragma once

#include <string>
#include <vector>

#include "scene/action.h"
#include "scene/scene.h"

namespace unietp {

/// When an episode ends at the latest: with this many steps done, or this many of them failed. The last `stop` counts.
struct StepLimits {
  int steps = 50, failures = 10;
};
/// The paper's: 50 and 10 in M1 and M2, 150 and 30 in M3.
StepLimits limits_of(Mode mode);

/// What an agent of a mode knows of a home before it looks around: all rooms; in M1 and M2 what stays where it is; in
/// M1 also what can be moved. Ids in the order of the scene.
struct GlobalInformation {
  std::vector<std::string> rooms, furniture, movables;
};
GlobalInformation global_information(const Scene& start, Mode mode);

/// Whether an agent of the mode is told the boxes and ids of the objects that it sees; in M3 it has the picture alone.
bool tells_boxes(Mode mode);

/// In M3 an argument means the object of the picture whose box agrees best with the one given, if by more than this
/// (both's pixels by either's).
inline constexpr double kLeastOverlap = 0.1;

}  // namespace unietp
