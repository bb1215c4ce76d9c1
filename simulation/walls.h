#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

namespace unietp {

/// A solid piece of wall: an upright box.
struct WallPiece {
  Pose pose;  // center
  Vec3 size = Vec3::Zero();
};

/// The walls of all rooms without the gaps at openings, and the lintels above those. Deterministic order.
std::vector<WallPiece> walls_of(const Scene& scene);

/// Where a ray meets the floor or the ceiling, which are planes behind everything else.
struct PlaneHit {
  double along = 0;  // in lengths of the ray's direction
  bool is_floor = true;
};
/// nullopt for level rays, and for those that go up from above the ceiling: from there, homes have none.
inline std::optional<PlaneHit> plane_behind(const Vec3& from, const Vec3& direction, double wall_height) {
  if (direction.z() < 0) return PlaneHit{-from.z() / direction.z(), true};
  if (direction.z() > 0 && from.z() < wall_height) return PlaneHit{(wall_height - from.z()) / direction.z(), false};
  return std::nullopt;
}

}  // namespace unietp
