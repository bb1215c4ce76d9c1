#pragma once

#include <optional>

#include "simulation/collider.h"

namespace unietp {

/// How two solids that overlap would come apart the shortest way.
struct Touch {
  Vec3 normal = Vec3::UnitZ();  // the first solid would go this way, W
  double depth = 0;             // and this far, metres, >= 0
};

/// Nullopt when the placed solids do not overlap. Boxes, balls and upright cylinders in closed form; cylinders that
/// lean by Bullet's GJK and EPA.
std::optional<Touch> touch(const Convex& a, const Convex& b);

/// Where a segment from `from` to `from + way` enters the placed solid, as a share of the way; nullopt when it does
/// not, or starts inside.
std::optional<double> entry(const Convex& solid, const Vec3& from, const Vec3& way);
/// Whether the segment meets the bounds before `most` of its way.
bool meets(const Bounds& bounds, const Vec3& from, const Vec3& way, double most);

}  // namespace unietp
