#include "simulation/camera.h"

#include <cmath>
#include <numbers>

namespace unietp {

std::optional<Vec2> Camera::pixel(const Vec3& point) const {
  constexpr double kNear_m = 0.02;
  const Vec3 way = point - at;
  const double deep = way.dot(ahead);
  if (deep < kNear_m) return std::nullopt;
  return Vec2(width / 2.0 + focal * way.dot(right) / deep, height / 2.0 + focal * way.dot(down) / deep);
}

bool Camera::may_show(const Vec3& center, double radius) const {
  const Vec3 way = center - at;
  const double deep = way.dot(ahead);
  if (deep < -radius) return false;
  const auto within = [&](double aside, double half) {  // of the two side planes: distance to the nearer one
    return std::abs(aside) * focal - deep * half <= radius * std::sqrt(focal * focal + half * half);
  };
  return within(way.dot(right), width / 2.0) && within(way.dot(down), height / 2.0);
}

Bounds Camera::shown_up_to(double depth_m) const {
  Bounds bounds{at, at};
  for (const double x : {0.0, static_cast<double>(width)}) {
    for (const double y : {0.0, static_cast<double>(height)}) {
      const Vec3 corner = at + depth_m * ray(x, y);
      bounds = {bounds.low.cwiseMin(corner), bounds.high.cwiseMax(corner)};
    }
  }
  return bounds;
}

Camera camera_of(const Agent& agent, const Profile& profile) {
  Camera camera;
  camera.at = Vec3(agent.position.x(), agent.position.y(), profile.camera_height_m);
  const double c = std::cos(agent.yaw), s = std::sin(agent.yaw);
  const double cp = std::cos(agent.pitch), sp = std::sin(agent.pitch);
  camera.ahead = Vec3(c * cp, s * cp, -sp);
  camera.right = Vec3(s, -c, 0);
  camera.down = camera.ahead.cross(camera.right);
  camera.width = profile.image_width;
  camera.height = profile.image_height;
  camera.focal = profile.image_height / 2.0 / std::tan(profile.vertical_fov_deg * std::numbers::pi / 360);
  return camera;
}

}  // namespace unietp
