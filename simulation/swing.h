#pragma once

#include <optional>
#include <span>

#include "simulation/physics.h"
#include "simulation/shape.h"

namespace unietp {

/// What the doors, lids and drawers of a node would meet on their way from its present opening to another one; slight
/// scraping is allowed. `ignore`: bodies that are left out; must contain the node itself.
std::optional<BodyId> joint_obstacle(const PhysicsWorld& world, const Node& node, const Shape& shape, double to,
                                     std::span<const BodyId> ignore);

}  // namespace unietp
