#pragma once

#include <cstdint>

#include "simulation/shape.h"

namespace unietp {

/// What a solid shows besides its object's body; pictures alone have the others.
enum class Skin : std::uint8_t { Body, Liquid, Water, Flame, Cord, Plug, Socket, Flap, Mouth };

/// An opaque convex solid in W.
struct Solid {
  Part::Kind kind = Part::Kind::Box;
  Pose pose;
  Vec3 size = Vec3::Zero();  // full extents, metres
  std::int32_t owner = -1;   // position in Scene::nodes; negative for walls
  bool moves = false;        // a door, lid or drawer
  Skin skin = Skin::Body;
};

}  // namespace unietp
