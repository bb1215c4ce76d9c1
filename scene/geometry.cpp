#include "scene/geometry.h"

#include <cmath>

namespace unietp {

Pose upright(const Vec3& position, double yaw) { return {position, Quat(std::cos(yaw / 2), 0, 0, std::sin(yaw / 2))}; }

double yaw_of(const Pose& pose) {
  const Vec3 right = rotated(pose.rotation, Vec3::UnitX());
  return std::atan2(right.y(), right.x());
}

bool contains(const std::vector<Vec2>& polygon, const Vec2& point) {
  // Most calls are about a point far outside of the polygon's bounds: those are answered first.
  bool right = false, left = false, above = false, below = false;
  for (const Vec2& corner : polygon) {
    (corner.x() > point.x() ? right : left) = true;
    (corner.y() > point.y() ? above : below) = true;
  }
  if (!right || !left || !above || !below) return false;
  bool inside = false;
  each_crossing(polygon, point.y(), [&](double x) {
    if (point.x() < x) inside = !inside;
  });
  return inside;
}

}  // namespace unietp
