#pragma once

#include <limits>

#include "simulation/solid.h"

namespace unietp {

/// Ray parameter of a miss.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// A solid with its transform from W into its own frame.
struct RayTarget {
  explicit RayTarget(const Solid& solid);
  Eigen::Matrix3d to_own;  // of points and directions
  Eigen::Matrix3d forms;   // of linear forms on W, as those on its own frame: the transposed inverse
  Vec3 center, half;
  SolidKind kind;
  bool sheared = false;
  Vec2 low = Vec2::Ones(), high = Vec2::Ones();  // half widths at z = -half.z() and half.z(), of the half extents
  double wall = 0, floor = 0;

  /// Whether rays enter it from above and meet its inside.
  bool hollow() const { return kind == SolidKind::Cup || kind == SolidKind::Crate; }
  /// A normal in its own frame as a unit vector in W.
  Vec3 normal_in_w(const Vec3& own) const;
};

/// Where a ray enters a solid from outside, and through which face. The hollow of a cup or crate is outside.
struct RayEntry {
  double along = kNever;       // in lengths of the ray's direction; kNever when it misses or begins inside
  Vec3 normal = Vec3::Zero();  // outwards, in the solid's own frame
};

/// `from` and `way` in the solid's own frame. Equal arguments give equal bits on every processor.
RayEntry enter(const RayTarget& solid, const Vec3& from, const Vec3& way);

}  // namespace unietp
