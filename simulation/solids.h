#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"
#include "simulation/camera.h"
#include "simulation/rays.h"

namespace unietp {

/// What no eye sees, as sorted places in the scene: what the agent holds, with what lies on or in it (it carries them
/// below the picture), and what is inside something closed.
std::vector<std::size_t> hidden_from_sight(const Scene& scene);

/// How far the parts of an object may reach from the centre of its box, doors included.
double sight_radius(const Node& node);

/// Appends an object's solids as physics has them; `owner` is what they are said to belong to.
void add_solids(const Node& node, std::int32_t owner, std::vector<Solid>& solids);

/// The solids at most `farthest` metres away that an image of this camera may show: objects but the hidden ones, in
/// order of the nodes, then walls. As physics has them; or `rounded`, for the eye: plates, mugs and bowls are round.
std::vector<Solid> solids_of(const Scene& scene, const Camera& camera, double farthest,
                             const std::vector<std::size_t>& hidden, bool rounded = false);

}  // namespace unietp
