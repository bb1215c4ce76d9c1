#pragma once

#include <optional>

#include "simulation/collider.h"

namespace unietp {

/// The minimum translation that separates two overlapping solids.
struct Touch {
  Vec3 normal = Vec3::UnitZ();  // direction in which the first solid would move, W
  double depth = 0;             // distance, meters, >= 0
};

/// Nullopt when the placed solids do not overlap. Boxes, balls and upright cylinders in closed form; tilted
/// cylinders by Bullet's GJK and EPA.
std::optional<Touch> touch(const Convex& a, const Convex& b);

/// Where a segment from `from` to `from + way` enters the placed solid, as a fraction of the segment; nullopt when it
/// misses or starts inside.
std::optional<double> entry(const Convex& solid, const Vec3& from, const Vec3& way);
/// Whether the segment meets the bounds before the fraction `most`.
bool meets(const Bounds& bounds, const Vec3& from, const Vec3& way, double most);

}  // namespace unietp
