#include "simulation/shadow.h"

#include <algorithm>
#include <cmath>

namespace unietp {
namespace {

constexpr double kStepOver_m = 0.05;  // lower things on the floor do not stop a body
constexpr double kLow_m = 0.15;       // movable things that start higher lie on furniture, which blocks the way itself

/// Lies in the other, and so adds nothing to it.
bool covered(const Shadow& f, const Shadow& by) {
  if (f.along != by.along) return false;
  const Vec2 d = f.centre - by.centre;
  const Vec2 local(std::abs(d.dot(by.along)), std::abs(d.dot(Vec2(-by.along.y(), by.along.x()))));
  return ((local + f.half - by.half).array() <= 0).all();
}

std::vector<Shadow> shadows_of(const Node& node, const Shape& shape, double opening, double body_height,
                               bool only_moving) {
  std::vector<Shadow> all;
  for (const Part& part : shape.parts) {
    if (only_moving && part.joint < 0) continue;
    const Pose pose = node.pose * joint_motion(shape, part.joint, opening) * part.pose;
    const auto f = shadow_of_box(pose, part.size, body_height);
    if (!f || std::any_of(all.begin(), all.end(), [&](const Shadow& other) { return covered(*f, other); })) continue;
    std::erase_if(all, [&](const Shadow& other) { return covered(other, *f); });
    all.push_back(*f);
  }
  return all;
}

}  // namespace

std::optional<Shadow> shadow_of_box(const Pose& pose, const Vec3& size, double body_height) {
  const Bounds bounds = bounds_of(pose, size);
  if (bounds.high.z() < kStepOver_m || bounds.low.z() > body_height) return std::nullopt;
  const Vec3 up = pose.rotation * Vec3::UnitZ();
  if (std::abs(up.z()) > 0.999) {
    const Vec3 x = pose.rotation * Vec3::UnitX();
    return Shadow{pose.position.head<2>(), x.head<2>().normalized(), size.head<2>() / 2};
  }
  return Shadow{(bounds.low + bounds.high).head<2>() / 2, Vec2::UnitX(), (bounds.high - bounds.low).head<2>() / 2};
}

double distance_to(const Shadow& f, const Vec2& point) {
  const Vec2 d = point - f.centre;
  const Vec2 local(std::abs(d.dot(f.along)), std::abs(d.dot(Vec2(-f.along.y(), f.along.x()))));
  return (local - f.half).cwiseMax(0.0).norm();
}

std::vector<Shadow> shadow_of(const Node& node, const Shape& shape, double body_height) {
  if (node.movable && !stands_low(bounds_of(node.pose, node.size))) return {};
  return shadows_of(node, shape, node.opening, body_height, false);
}

std::vector<Shadow> door_way(const Node& node, const Shape& shape, const Profile& profile) {
  std::vector<Shadow> way;
  if (!node.openable) return way;
  for (const double opening : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const auto parts = shadows_of(node, shape, opening, profile.body_height_m, true);
    way.insert(way.end(), parts.begin(), parts.end());
  }
  return way;
}

bool within(const std::vector<Shadow>& footprints, const Vec2& at, double radius) {
  return std::any_of(footprints.begin(), footprints.end(),
                     [&](const Shadow& f) { return distance_to(f, at) < radius; });
}

bool stands_low(const Bounds& bounds) { return bounds.low.z() < kLow_m; }

bool in_door_way(const Node& node, const Vec2& at, const Profile& profile) {
  return within(door_way(node, shape_of(node), profile), at, profile.body_radius_m);
}

}  // namespace unietp
