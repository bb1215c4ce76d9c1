#pragma once

#include <optional>
#include <span>

#include "simulation/physics.h"
#include "simulation/shape.h"

namespace unietp {

/// What the doors, lids and drawers of a node would meet on their way from its present opening to another one; a little
/// scraping is none. `ignore`: what is left out, the node itself too.
std::optional<BodyId> in_the_way(const PhysicsWorld& world, const Node& node, const Shape& shape, double to,
                                 std::span<const BodyId> ignore);

}  // namespace unietp
