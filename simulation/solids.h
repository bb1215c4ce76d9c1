#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"
#include "simulation/camera.h"
#include "simulation/rays.h"

namespace unietp {

/// Invisible nodes, as sorted positions in the scene: what the agent holds, with what lies on or in it (below the
/// picture), and what is inside something closed.
std::vector<std::size_t> hidden_from_sight(const Scene& scene);

/// Radius of a sphere around the centre of an object's box that contains all its parts, doors included.
double sight_radius(const Node& node);

/// Appends an object's solids as physics has them; `owner` is stored in each.
void add_solids(const Node& node, std::int32_t owner, std::vector<Solid>& solids);

/// The same for display: plates, mugs and bowls are round, and there is what shows states (state_solids.h).
void add_shown(const Node& node, std::int32_t owner, std::vector<Solid>& solids);

/// The solids at most `farthest` metres away that an image of this camera may show: objects but the hidden ones, in
/// order of the nodes, then walls. As in physics; or `rounded` for display (add_shown).
std::vector<Solid> solids_of(const Scene& scene, const Camera& camera, double farthest,
                             const std::vector<std::size_t>& hidden, bool rounded = false);

}  // namespace unietp
