#pragma once

#include <optional>

#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// The agent's eye: a pinhole at the profile's camera height above the agent's place, turned by its yaw and pitch.
/// Pixels count from the upper left corner, x to the right, y down; pixel (0, 0) covers [0, 1) x [0, 1).
struct Camera {
  Vec3 at = Vec3::Zero();                                                     // W, meters
  Vec3 ahead = Vec3::UnitX(), right = -Vec3::UnitY(), down = -Vec3::UnitZ();  // unit, W
  int width = 0, height = 0;                                                  // pixels
  double focal = 1;                                                           // pixels
  bool operator==(const Camera&) const = default;

  /// Direction from `at` through a point of the image; the point at t times it has a depth of t meters.
  Vec3 ray(double x, double y) const {
    return ahead + ((x - width / 2.0) / focal) * right + ((y - height / 2.0) / focal) * down;
  }
  /// Distance along the view direction, meters; negative behind the camera.
  double depth(const Vec3& point) const { return (point - at).dot(ahead); }
  /// Pixel coordinates of a point, which may lie outside of the image; nullopt when it is behind the camera.
  std::optional<Vec2> pixel(const Vec3& point) const;
  /// Bounds of the view frustum up to a depth, meters.
  Bounds shown_up_to(double depth_m) const;
  /// Whether a sphere may be in the image: conservative test against the view frustum.
  bool may_show(const Vec3& center, double radius) const;
};

/// The camera of an agent at its present position, yaw and pitch.
Camera camera_of(const Agent& agent, const Profile& profile);

}  // namespace unietp
