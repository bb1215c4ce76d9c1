#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "simulation/solid.h"
#include "simulation/walls.h"

namespace unietp {

/// Appends what is seen of an object's states besides its body, whose solids begin at `first`: the liquid in it,
/// through which what lies in it is seen, running water, a flame, a plug in or out of a socket (plug_solids.h), a flap
/// (over a dark mouth, if it has no hollow) where nothing else shows that it is open. Physics has none of these.
void add_state_solids(const Node& node, std::int32_t owner, std::size_t first, bool shows_open,
                      std::span<const WallPiece> walls, std::vector<Solid>& solids);

/// At least how far these may stand out of a sphere around the object's box, meters.
double reach_of_states(const Node& node);

}  // namespace unietp
