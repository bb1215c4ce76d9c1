#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "simulation/profile.h"
#include "simulation/shape.h"

namespace unietp {

/// The footprint of a solid on the floor: a rectangle turned by its yaw, or its bounds when it is not upright.
struct FloorFootprint {
  Vec2 center = Vec2::Zero(), along = Vec2::UnitX(), half = Vec2::Zero();  // `along`: unit, the rectangle's own x
  bool operator==(const FloorFootprint& other) const {
    return center == other.center && along == other.along && half == other.half;
  }
};

/// Meters from the rectangle; 0 inside.
double distance_to(const FloorFootprint& shadow, const Vec2& point);
/// Whether a disc of that radius around the point meets one of them.
bool within(const std::vector<FloorFootprint>& shadows, const Vec2& at, double radius);

/// The footprint of a box that blocks a body; nullopt when the body steps over it or walks under it.
std::optional<FloorFootprint> footprint_of_box(const Pose& pose, const Vec3& size, double body_height);
/// The footprints of the parts of a node that block a body; none for a movable object on furniture.
std::vector<FloorFootprint> footprint_of(const Node& node, const Shape& shape, double body_height);
/// The area that the node's door, lid or drawer sweeps, sampled in steps.
std::vector<FloorFootprint> door_sweep(const Node& node, const Shape& shape, const Profile& profile);

/// Whether a movable object with these bounds blocks walking, being on or near the floor.
bool stands_low(const Bounds& bounds);
/// True when a body standing at `at` would be hit by the node's door, lid or drawer on its way.
bool in_door_sweep(const Node& node, const Vec2& at, const Profile& profile);

}  // namespace unietp
