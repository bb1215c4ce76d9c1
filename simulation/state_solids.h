#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "simulation/solid.h"

namespace unietp {

/// Appends what a picture shows of an object's states besides its body, whose solids begin at `first`: the liquid in
/// it, running water, a flame, a plug in or out of a socket, a flap over a dark mouth where nothing else shows that it
/// is open. Physics has none of these.
void add_state_solids(const Node& node, std::int32_t owner, std::size_t first, bool shows_open,
                      std::vector<Solid>& solids);

}  // namespace unietp
