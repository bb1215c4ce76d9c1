#include "simulation/viewpoint.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "simulation/solids.h"
#include "simulation/view.h"

namespace unietp {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

/// Looks along `ahead`, which is a unit vector.
Camera looking(const Vec3& at, const Vec3& ahead, const Vec3& right, const Profile& profile, double fov_deg) {
  Camera camera;
  camera.at = at;
  camera.ahead = ahead;
  camera.right = right;
  camera.down = ahead.cross(right);
  camera.width = profile.image_width;
  camera.height = profile.image_height;
  camera.focal = profile.image_height / 2.0 / std::tan(fov_deg * kRadians / 2);
  return camera;
}

Camera from_behind(const Scene& scene, const Profile& profile, Rays& rays) {
  constexpr double kAway_m = 2.2, kFree_m = 0.15, kFov_deg = 60;  // of other solids
  constexpr std::array kUp_deg{20.0, 35.0, 50.0, 65.0, 80.0};
  const double c = std::cos(scene.agent.yaw), s = std::sin(scene.agent.yaw);
  const Vec3 ahead(c, s, 0), right(s, -c, 0);
  const Vec3 chest(scene.agent.position.x(), scene.agent.position.y(), 0.75 * profile.body_height_m);
  Camera back = looking(chest, -ahead, -right, profile, kFov_deg);
  back.focal = 1e-3;  // shows the whole half space behind the agent
  rays.build(solids_of(scene, back, kAway_m + kFree_m, hidden_from_sight(scene)));
  double most = 0;
  Vec3 best = -ahead;
  for (const double up : kUp_deg) {
    const Vec3 way = -std::cos(up * kRadians) * ahead + std::sin(up * kRadians) * Vec3::UnitZ();
    const auto hit = rays.first(chest, way, kAway_m + kFree_m);
    const double free = (hit ? hit->along : kAway_m + kFree_m) - kFree_m;
    if (free <= most) continue;
    most = free;
    best = way;
  }
  const Vec3 at = chest + most * best, seen = chest + 0.5 * ahead;
  return looking(at, (seen - at).normalized(), right, profile, kFov_deg);
}

Camera from_above(const Scene& scene, const Profile& profile) {
  constexpr double kFov_deg = 25, kAround_m = 0.3;
  Vec2 low = scene.agent.position, high = low;
  for (const Room& room : scene.rooms) {
    for (const Vec2& corner : room.polygon) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  }
  const Vec2 middle = (low + high) / 2, half = (high - low) / 2 + Vec2::Constant(kAround_m);
  Camera camera = looking(Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitX(), profile, kFov_deg);
  const double away = camera.focal * std::max(2 * half.x() / camera.width, 2 * half.y() / camera.height);
  camera.at = Vec3(middle.x(), middle.y(), scene.wall_height + away);
  return camera;
}

}  // namespace

std::string_view name_of(Viewpoint viewpoint) {
  switch (viewpoint) {
    case Viewpoint::Agent:
      return "agent";
    case Viewpoint::Behind:
      return "behind";
    case Viewpoint::Above:
      return "above";
  }
  return "";
}

std::optional<Viewpoint> viewpoint_named(std::string_view name) {
  for (const Viewpoint one : kViewpoints) {
    if (name_of(one) == name) return one;
  }
  return std::nullopt;
}

Scene with_agent(const Scene& scene, const Profile& profile) {
  Scene staged = scene;
  staged.agent.held.clear();  // so that it is not hidden: its pose is that of the hand
  Node body;
  body.id = "agent";
  body.category = "HouseholdRobot";  // data/shapes/categories.csv
  body.size = Vec3(2 * profile.body_radius_m, 2 * profile.body_radius_m, profile.body_height_m);
  body.pose = upright(Vec3(scene.agent.position.x(), scene.agent.position.y(), profile.body_height_m / 2),
                      scene.agent.yaw + std::numbers::pi / 2);  // its front is -y
  staged.nodes.push_back(std::move(body));
  return staged;
}

Shot shot_of(const Scene& scene, const Profile& profile, Viewpoint viewpoint, Rays& rays) {
  switch (viewpoint) {
    case Viewpoint::Agent:
      break;
    case Viewpoint::Behind:
      return {with_agent(scene, profile), from_behind(scene, profile, rays)};
    case Viewpoint::Above:
      return {with_agent(scene, profile), from_above(scene, profile)};
  }
  return {scene, camera_of(scene.agent, profile)};
}

Picture picture_from(const Scene& scene, const Profile& profile, Viewpoint viewpoint, Rays& rays) {
  if (viewpoint == Viewpoint::Agent) return picture_of(scene, profile, rays);
  const Shot shot = shot_of(scene, profile, viewpoint, rays);
  return picture_of(viewed(shot.scene), shot.camera, rays);
}

Channels channels_from(const Scene& scene, const Profile& profile, Viewpoint viewpoint, Rays& rays) {
  const Shot shot = shot_of(scene, profile, viewpoint, rays);
  return channels_of(shot.scene, shot.camera);
}

}  // namespace unietp
