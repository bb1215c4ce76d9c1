#pragma once

#include <vector>

#include "scene/scene.h"

namespace unietp {

/// A solid piece of wall: an upright box.
struct WallPiece {
  Pose pose;  // centre
  Vec3 size = Vec3::Zero();
};

/// The walls of all rooms without the gaps at openings, and the lintels above those. Deterministic order.
std::vector<WallPiece> walls_of(const Scene& scene);

}  // namespace unietp
