#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "shapes/family.h"
#include "simulation/camera.h"
#include "simulation/rays.h"
#include "simulation/walls.h"

namespace unietp {

/// Invisible nodes, as sorted positions in the scene: what the agent holds, with what lies on or in it (below the
/// picture), and what is inside something closed.
std::vector<std::size_t> hidden_from_sight(const Scene& scene);

/// Radius of a sphere around the center of an object's box that contains all that is seen of it, doors, cords and water
/// included.
double sight_radius(const Node& node);

/// The shape of an object for the eye; nullptr for those that look like their archetype or have boards.
const ShapeFamily* family_of(const Node& node, Simulator simulator);

/// Appends the solids that an object is seen as: the pieces of its category's shape, or the parts of its archetype, and
/// what shows its states (state_solids.h). `owner` is stored in each; `walls`: those that a plug may be in.
void add_solids(const Node& node, std::int32_t owner, Simulator simulator, std::span<const WallPiece> walls,
                std::vector<Solid>& solids);

/// The solids at most `farthest` meters away that an image of this camera may show: objects but the hidden ones, in
/// order of the nodes, then walls.
std::vector<Solid> solids_of(const Scene& scene, const Camera& camera, double farthest,
                             const std::vector<std::size_t>& hidden);

}  // namespace unietp
