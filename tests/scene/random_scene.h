#pragma once

#include "core/rng.h"
#include "scene/scene.h"

namespace unietp {

/// A sound scene of 0 … 40 objects in 1 … 3 rooms with numbers that are awkward to write: any sign, any magnitude.
Scene random_scene(Rng& rng);
/// A sound successor: objects moved, changed, removed and added at the end, edges and agent changed; maybe nothing.
Scene random_successor(Scene scene, Rng& rng);
Node random_node(std::string id, Rng& rng);

}  // namespace unietp
