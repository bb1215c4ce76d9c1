#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "simulation/solid.h"

namespace unietp {

/// Appends what a picture shows of an object's states besides its body: the liquid in it, running water, a flame, a
/// plug in or out of a socket, a flap over a dark mouth where nothing else shows that it is open. Physics has none of
/// these. `round`: the body is drawn round.
void add_state_solids(const Node& node, std::int32_t owner, bool round, std::vector<Solid>& solids);

}  // namespace unietp
