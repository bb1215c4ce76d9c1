#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "simulation/profile.h"
#include "simulation/shape.h"

namespace unietp {

/// A solid seen from above: a rectangle turned by its yaw, or its bounds when it does not stand upright.
struct Shadow {
  Vec2 centre = Vec2::Zero(), along = Vec2::UnitX(), half = Vec2::Zero();  // `along`: unit, the rectangle's own x
  bool operator==(const Shadow& other) const {
    return centre == other.centre && along == other.along && half == other.half;
  }
};

/// Metres from the rectangle; 0 inside.
double distance_to(const Shadow& shadow, const Vec2& point);
/// Whether a disc of that radius around the point meets one of them.
bool within(const std::vector<Shadow>& shadows, const Vec2& at, double radius);

/// Of a box that a body would meet: not so low that it steps over it, nor above its head.
std::optional<Shadow> shadow_of_box(const Pose& pose, const Vec3& size, double body_height);
/// What of a node stands in the way of a body. None of a movable thing that lies on furniture.
std::vector<Shadow> shadow_of(const Node& node, const Shape& shape, double body_height);
/// All that the node's door, lid or drawer sweeps, in steps.
std::vector<Shadow> door_way(const Node& node, const Shape& shape, const Profile& profile);

/// Whether a movable thing with these bounds is in the way of walking: it is on or near the floor.
bool stands_low(const Bounds& bounds);
/// True when a body standing at `at` would be hit by the node's door, lid or drawer somewhere on its way.
bool in_door_way(const Node& node, const Vec2& at, const Profile& profile);

}  // namespace unietp
