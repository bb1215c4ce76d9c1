#include "simulation/daylight.h"

#include <algorithm>
#include <cmath>

#include "simulation/finish.h"

namespace unietp {
namespace {

constexpr double kSkyReach_m = 5;

bool is_in(const Daylight& window, const Vec3& at) {
  return at.x() >= window.around.low.x() && at.x() <= window.around.high.x() && at.y() >= window.around.low.y() &&
         at.y() <= window.around.high.y() && contains(window.room->polygon, at.head<2>());
}

}  // namespace

std::vector<Daylight> daylight_of(const Scene& scene, const Camera& camera, double farthest) {
  constexpr double kFrame_m = 0.05, kInside_m = 0.2;
  std::vector<Daylight> windows;
  for (const Node& node : scene.nodes) {
    if (!is_window(node) || (node.pose.position - camera.at).norm() > farthest) continue;
    Daylight window;
    window.at = node.pose.position;
    window.inward = rotated(node.pose.rotation, -Vec3::UnitY());
    window.half = Vec2(node.size.x(), node.size.z()) / 2 - Vec2::Constant(kFrame_m);
    window.room = room_at(scene, (window.at + kInside_m * window.inward).head<2>());
    if (window.room == nullptr || window.half.minCoeff() <= 0) continue;
    window.around = room_bounds(*window.room, scene.wall_height);
    windows.push_back(window);
  }
  return windows;
}

Vec3 sky_light(const std::vector<Daylight>& windows, const Vec3& at, const Vec3& normal) {
  constexpr double kStrength = 0.9, kAround = 0.25;  // on faces turned away
  double sum = 0;
  for (const Daylight& window : windows) {
    const Vec3 way = window.at - at;
    const double before = -way.dot(window.inward), far = way.squaredNorm();
    if (before <= 0 || far > kSkyReach_m * kSkyReach_m || !is_in(window, at)) continue;
    const double away = std::sqrt(far), area = 4 * window.half.prod();
    const double facing = std::max(kAround, normal.dot(way) / away), fade = 1 - far / (kSkyReach_m * kSkyReach_m);
    sum += kStrength * area * before / away * facing * fade / (far + area);
  }
  return sum * Vec3(0.9, 0.96, 1);
}

Vec3 toward_sun() { return Vec3(0.5, 0.5, std::sqrt(0.5)); }

std::optional<double> way_to_sunny_pane(const std::vector<Daylight>& windows, const Vec3& at) {
  constexpr double kBar_m = 0.02;
  const Vec3 sun = toward_sun();
  for (const Daylight& window : windows) {
    const double out = -sun.dot(window.inward), before = (at - window.at).dot(window.inward);
    if (out <= 0 || before <= 0) continue;
    const double along = before / out;
    const Vec3 met = at + along * sun - window.at;
    const double up = std::abs(met.z()), aside = std::abs(met.dot(Vec3(-window.inward.y(), window.inward.x(), 0)));
    if (up > window.half.y() || aside > window.half.x() || up < kBar_m || aside < kBar_m || !is_in(window, at))
      continue;
    return along;
  }
  return std::nullopt;
}

}  // namespace unietp
