#pragma once

#include <vector>

#include "scene/scene.h"
#include "simulation/surface.h"

namespace unietp {

/// The surfaces on boards, in the frame of their object: as large as the boards of a joint whose upper faces are level
/// allow together, with at least 3 cm free above. They may overlap: where something hangs low above a part, there is
/// one for that part and a higher one beside it. Cavities are not looked at. Deterministic.
std::vector<Surface> surfaces_on(const std::vector<Board>& boards);

}  // namespace unietp
