#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "simulation/solid.h"
#include "simulation/walls.h"

namespace unietp {

/// Appends the cord and the plug of what is plugged in or unplugged. Plugged in beside a wall: a socket in that wall.
/// Elsewhere: the socket of an extension cord, which lies along the thing. Unplugged: a plug whose prongs are seen,
/// along the thing, or on the floor before what stands there. What lies along a thing is thinner than the gap that
/// people leave beside it, so that it goes through nothing.
void add_plug_solids(const Node& node, std::int32_t owner, std::span<const WallPiece> walls,
                     std::vector<Solid>& solids);

}  // namespace unietp
