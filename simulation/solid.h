#pragma once

#include <cstdint>

#include "simulation/shape.h"

namespace unietp {

/// A convex solid in W that light does not pass.
struct Solid {
  Part::Kind kind = Part::Kind::Box;
  Pose pose;
  Vec3 size = Vec3::Zero();  // full extents, metres
  std::int32_t owner = -1;   // position in Scene::nodes; negative: none's, a wall
  bool moves = false;        // a door, lid or drawer
};

}  // namespace unietp
