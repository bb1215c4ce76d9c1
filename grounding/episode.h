#pragma once

#include <string>
#include <vector>

#include "generator/specification.h"
#include "scene/start.h"

namespace unietp {

/// A specification grounded in a scene whose start has been checked using only physics.
struct Episode {
  Specification specification;
  std::string layout;              // id of the base scene
  Delta changes;                   // from the base scene to the start
  Scene start;                     // start_in(base scene, changes): at rest, edges read
  std::vector<std::string> edits;  // what was changed to meet the start, for people: "added Mug mug_4 on CounterTop_1"
};

}  // namespace unietp
