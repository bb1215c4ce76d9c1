#include "simulation/view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "simulation/navigation.h"

namespace unietp {
namespace {

/// A pinhole camera: x right, y down, z ahead.
class Camera {
 public:
  Camera(const Agent& agent, const Profile& profile)
      : at_(agent.position.x(), agent.position.y(), profile.camera_height_m),
        width_(profile.image_width),
        height_(profile.image_height),
        focal_(profile.image_height / 2.0 / std::tan(profile.vertical_fov_deg * std::numbers::pi / 360)) {
    const double c = std::cos(agent.yaw), s = std::sin(agent.yaw);
    const double cp = std::cos(agent.pitch), sp = std::sin(agent.pitch);
    ahead_ = Vec3(c * cp, s * cp, -sp);
    right_ = Vec3(s, -c, 0);
    down_ = ahead_.cross(right_);
  }

  const Vec3& at() const { return at_; }

  /// Pixel of a point, or nullopt when it lies behind the image plane.
  std::optional<Vec2> pixel(const Vec3& point) const {
    constexpr double kNear_m = 0.05;
    const Vec3 d = point - at_;
    const double depth = d.dot(ahead_);
    if (depth < kNear_m) return std::nullopt;
    return Vec2(width_ / 2.0 + focal_ * d.dot(right_) / depth, height_ / 2.0 + focal_ * d.dot(down_) / depth);
  }
  bool in_image(const Vec3& point) const {
    const auto p = pixel(point);
    return p && p->x() >= 0 && p->y() >= 0 && p->x() < width_ && p->y() < height_;
  }
  /// Pixel box of an oriented box; a corner behind the camera opens it to the image's edges.
  std::array<int, 4> box(const Node& node) const {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (int i = 0; i < 8; ++i) {
      const Vec3 half = node.size / 2;
      const Vec3 corner((i & 1) ? half.x() : -half.x(), (i & 2) ? half.y() : -half.y(), (i & 4) ? half.z() : -half.z());
      const auto p = pixel(node.pose * corner);
      if (!p) return {0, 0, width_ - 1, height_ - 1};
      low = low.cwiseMin(*p);
      high = high.cwiseMax(*p);
    }
    const auto clip = [](double value, int size) {
      return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(size - 1)));
    };
    return {clip(low.x(), width_), clip(low.y(), height_), clip(high.x(), width_), clip(high.y(), height_)};
  }

 private:
  Vec3 at_, ahead_, right_, down_;
  int width_, height_;
  double focal_;
};

}  // namespace

std::vector<VisibleObject> view_of(const Scene& scene, const PhysicsWorld& world, const Profile& profile) {
  const Camera camera(scene.agent, profile);
  std::vector<VisibleObject> visible;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (!world.has(static_cast<BodyId>(i))) continue;  // in the agent's hand
    if ((node.pose.position - camera.at()).norm() > profile.sight_m) continue;
    const std::vector<Vec3> points = sight_points(node);
    const bool seen = std::any_of(points.begin(), points.end(), [&](const Vec3& point) {
      if (!camera.in_image(point)) return false;
      const auto hit = world.ray(camera.at(), point);
      return !hit || hit->body == i;
    });
    if (seen) visible.push_back({node.id, camera.box(node)});
  }
  std::sort(visible.begin(), visible.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return visible;
}

}  // namespace unietp
