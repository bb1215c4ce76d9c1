#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace unietp {

using Vec2 = Eigen::Vector2d;     // meters, in a plan unless said otherwise
using Vec3 = Eigen::Vector3d;     // meters, z up
using Quat = Eigen::Quaterniond;  // a rotation of unit length, (w, x, y, z)

/// Position in meters and unit rotation, object frame in world frame W (right-handed, z up) unless a name says else.
struct Pose {
  Vec3 position = Vec3::Zero();
  Quat rotation = Quat::Identity();

  bool operator==(const Pose& other) const {
    return position == other.position && rotation.coeffs() == other.rotation.coeffs();
  }
};

/// The same bits as Eigen's `rotation * v`, which the compiler does not inline.
inline Vec3 rotated(const Quat& rotation, const Vec3& v) {
  const Vec3 twice = 2 * rotation.vec().cross(v);
  return v + rotation.w() * twice + rotation.vec().cross(twice);
}

/// Coordinates in frame A of a point given in frame B.
inline Vec3 operator*(const Pose& a_from_b, const Vec3& point_b) {
  return a_from_b.position + rotated(a_from_b.rotation, point_b);
}
/// Composition: the pose of C in A.
inline Pose operator*(const Pose& a_from_b, const Pose& b_from_c) {
  return {a_from_b * b_from_c.position, a_from_b.rotation * b_from_c.rotation};
}
/// b_from_a of a_from_b.
inline Pose inverse(const Pose& pose) {
  const Quat back = pose.rotation.conjugate();
  return {-rotated(back, pose.position), back};
}
/// Upright pose turned by `yaw` radians about z.
Pose upright(const Vec3& position, double yaw);
/// Angle of the pose's x axis about z, radians in (-pi, pi]; for upright poses.
double yaw_of(const Pose& pose);

/// Axis-aligned box in W, meters.
struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  bool operator==(const Bounds& other) const { return low == other.low && high == other.high; }
};
/// The bounds of an oriented box with full extents `size` centered at `pose`.
inline Bounds bounds_of(const Pose& pose, const Vec3& size) {
  const Vec3 reach = pose.rotation.toRotationMatrix().cwiseAbs() * size / 2;
  return {pose.position - reach, pose.position + reach};
}
/// Whether two boxes, with less than `gap` meters between them, count as touching. Boxes that only share a face do not
/// overlap with gap 0.
inline bool overlap(const Bounds& a, const Bounds& b, double gap = 0.0) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.low[axis] >= b.high[axis] + gap || b.low[axis] >= a.high[axis] + gap) return false;
  }
  return true;
}

/// Visits each x at which a polygon's border crosses the height y, in no order. An edge owns its lower end only, so a
/// point on the border that two rooms share lies in exactly one of them.
template <class Visit>
void each_crossing(const std::vector<Vec2>& polygon, double y, Visit visit) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[j];
    if ((a.y() > y) == (b.y() > y)) continue;
    const Vec2& low = a.y() < b.y() ? a : b;  // the same operand order for both rooms of a shared wall
    const Vec2& high = a.y() < b.y() ? b : a;
    visit(low.x() + (y - low.y()) / (high.y() - low.y()) * (high.x() - low.x()));
  }
}

/// True when the point lies in the polygon (counter-clockwise or clockwise, meters).
bool contains(const std::vector<Vec2>& polygon, const Vec2& point);

}  // namespace unietp
