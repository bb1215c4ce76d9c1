#include "scene/geometry.h"

#include <cmath>

namespace unietp {

Pose upright(const Vec3& position, double yaw) { return {position, Quat(std::cos(yaw / 2), 0, 0, std::sin(yaw / 2))}; }

double yaw_of(const Pose& pose) {
  const Vec3 right = rotated(pose.rotation, Vec3::UnitX());
  return std::atan2(right.y(), right.x());
}

bool contains(const std::vector<Vec2>& polygon, const Vec2& point) {
  // Crossings of the ray to +x. An edge owns its lower end only, so a point on the border that two rooms share lies in
  // exactly one of them.
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const Vec2& low = a.y() < b.y() ? a : b;  // the same operand order for both rooms of a shared wall
    const Vec2& high = a.y() < b.y() ? b : a;
    const double cross_x = low.x() + (point.y() - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
    if (point.x() < cross_x) inside = !inside;
  }
  return inside;
}

}  // namespace unietp
