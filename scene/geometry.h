#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace unietp {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Quat = Eigen::Quaterniond;

/// Position in metres and unit rotation, object frame in world frame W (right-handed, z up) unless a name says else.
struct Pose {
  Vec3 position = Vec3::Zero();
  Quat rotation = Quat::Identity();

  bool operator==(const Pose& other) const {
    return position == other.position && rotation.coeffs() == other.rotation.coeffs();
  }
};

Pose operator*(const Pose& a_from_b, const Pose& b_from_c);
Vec3 operator*(const Pose& a_from_b, const Vec3& point_b);
Pose inverse(const Pose& pose);
/// Upright pose turned by `yaw` radians about z.
Pose upright(const Vec3& position, double yaw);
double yaw_of(const Pose& pose);

/// Axis-aligned box in W, metres.
struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  bool operator==(const Bounds& other) const { return low == other.low && high == other.high; }
};
/// The bounds of an oriented box with full extents `size` centred at `pose`.
Bounds bounds_of(const Pose& pose, const Vec3& size);
bool overlap(const Bounds& a, const Bounds& b, double gap = 0.0);

/// True when the point lies in the polygon (counter-clockwise or clockwise, metres).
bool contains(const std::vector<Vec2>& polygon, const Vec2& point);

}  // namespace unietp
