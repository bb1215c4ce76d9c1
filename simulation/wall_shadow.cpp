#include "simulation/wall_shadow.h"

#include <algorithm>
#include <cmath>

namespace unietp {

std::optional<WallShadow> WallShadow::of(const WallPiece& wall, const Vec3& eye) {
  const Eigen::Matrix3d axes = wall.pose.rotation.toRotationMatrix();
  const int thin = wall.size.x() < wall.size.y() ? 0 : 1, wide = 1 - thin;
  const double ahead = (eye - wall.pose.position).dot(axes.col(thin));
  const Vec3 outward = ahead < 0 ? Vec3(-axes.col(thin)) : Vec3(axes.col(thin));
  const double away = std::abs(ahead) - wall.size[thin] / 2;
  constexpr double kLeast_m = 0.01;  // nearer, the planes through the edges are ill defined
  if (away < kLeast_m) return std::nullopt;
  const Vec3 middle = wall.pose.position + outward * (wall.size[thin] / 2);
  const Vec3 aside = axes.col(wide) * (wall.size[wide] / 2), up = axes.col(2) * (wall.size.z() / 2);
  const std::array<Vec3, 4> corners{middle - aside - up, middle + aside - up, middle + aside + up, middle - aside + up};
  WallShadow shadow;
  shadow.planes_[4] = {-outward, -outward.dot(middle)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Vec3 normal = (corners[i] - eye).cross(corners[(i + 1) % corners.size()] - eye).normalized();
    if (normal.dot(middle - eye) < 0) normal = -normal;
    shadow.planes_[i] = {normal, normal.dot(eye)};
  }
  const double squared = (middle - eye).squaredNorm();
  shadow.angle_ = wall.size[wide] * wall.size.z() * away / (squared * std::sqrt(squared));
  return shadow;
}

bool WallShadow::hides(const Vec3& center, double radius) const {
  constexpr double kMargin_m = 0.001;
  return std::all_of(planes_.begin(), planes_.end(),
                     [&](const Plane& plane) { return plane.normal.dot(center) - plane.offset >= radius + kMargin_m; });
}

}  // namespace unietp
