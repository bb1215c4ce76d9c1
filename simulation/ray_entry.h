#pragma once

#include <limits>

#include "simulation/solid.h"

namespace unietp {

/// Ray parameter of a miss.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A solid with its transform from W into its own frame.
struct RayTarget {
  explicit RayTarget(const Solid& solid);
  Eigen::Matrix3d to_own;
  Vec3 centre, half;
  Part::Kind kind;
};

/// Where a ray enters a solid from outside, and through which face.
struct RayEntry {
  double along = kNever;       // in lengths of the ray's direction; kNever when it misses or begins inside
  Vec3 normal = Vec3::Zero();  // outwards, in the solid's own frame
};

/// `from` and `way` in the solid's own frame. Equal arguments give equal bits on every processor.
RayEntry enter(const RayTarget& solid, const Vec3& from, const Vec3& way);

}  // namespace unietp
