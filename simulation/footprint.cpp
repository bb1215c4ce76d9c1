#include "simulation/footprint.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

constexpr double kStepOver_m = 0.05;  // lower objects do not block a body
constexpr double kLow_m = 0.15;       // movable objects above this lie on furniture, which blocks the body anyway

/// Whether one footprint is inside the other.
bool covered(const FloorFootprint& f, const FloorFootprint& by) {
  if (f.along != by.along) return false;
  const Vec2 d = f.center - by.center;
  const Vec2 local(std::abs(d.dot(by.along)), std::abs(d.dot(Vec2(-by.along.y(), by.along.x()))));
  return ((local + f.half - by.half).array() <= 0).all();
}

std::vector<FloorFootprint> shadows_of(const Node& node, const Shape& shape, double opening, double body_height,
                                       bool only_moving) {
  std::vector<FloorFootprint> all;
  for (const Part& part : shape.parts) {
    if (only_moving && part.joint < 0) continue;
    const Pose pose = node.pose * joint_motion(shape, part.joint, opening) * part.pose;
    const auto f = footprint_of_box(pose, part.size, body_height);
    if (!f || std::any_of(all.begin(), all.end(), [&](const FloorFootprint& other) { return covered(*f, other); }))
      continue;
    std::erase_if(all, [&](const FloorFootprint& other) { return covered(other, *f); });
    all.push_back(*f);
  }
  return all;
}

}  // namespace

std::optional<FloorFootprint> footprint_of_box(const Pose& pose, const Vec3& size, double body_height) {
  const Bounds bounds = bounds_of(pose, size);
  if (bounds.high.z() < kStepOver_m || bounds.low.z() > body_height) return std::nullopt;
  const Vec3 up = pose.rotation * Vec3::UnitZ();
  if (std::abs(up.z()) > 0.999) {
    const Vec3 x = pose.rotation * Vec3::UnitX();
    return FloorFootprint{pose.position.head<2>(), x.head<2>().normalized(), size.head<2>() / 2};
  }
  return FloorFootprint{(bounds.low + bounds.high).head<2>() / 2, Vec2::UnitX(),
                        (bounds.high - bounds.low).head<2>() / 2};
}

double distance_to(const FloorFootprint& f, const Vec2& point) {
  const Vec2 d = point - f.center;
  const Vec2 local(std::abs(d.dot(f.along)), std::abs(d.dot(Vec2(-f.along.y(), f.along.x()))));
  return (local - f.half).cwiseMax(0.0).norm();
}

std::vector<FloorFootprint> footprint_of(const Node& node, const Shape& shape, double body_height) {
  if (node.movable && !stands_low(bounds_of(node.pose, node.size))) return {};
  return shadows_of(node, shape, node.opening, body_height, false);
}

std::vector<FloorFootprint> door_sweep(const Node& node, const Shape& shape, const Profile& profile) {
  std::vector<FloorFootprint> way;
  if (!node.openable) return way;
  for (const double opening : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const auto parts = shadows_of(node, shape, opening, profile.body_height_m, true);
    way.insert(way.end(), parts.begin(), parts.end());
  }
  return way;
}

bool within(const std::vector<FloorFootprint>& footprints, const Vec2& at, double radius) {
  return std::any_of(footprints.begin(), footprints.end(),
                     [&](const FloorFootprint& f) { return distance_to(f, at) < radius; });
}

bool stands_low(const Bounds& bounds) { return bounds.low.z() < kLow_m; }

bool in_door_sweep(const Node& node, const Vec2& at, const Profile& profile) {
  return within(door_sweep(node, shape_of(node), profile), at, profile.body_radius_m);
}

}  // namespace unietp
