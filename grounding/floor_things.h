#pragma once

#include "core/rng.h"
#include "grounding/recipe.h"
#include "grounding/workspace.h"
#include "simulation/walk.h"

namespace unietp {

/// Stage: puts at most `wanted` movable things on the floors of a furnished home, of the categories that the
/// workspace's household keeps there (shoes, bags, balls, plungers), in rooms where people keep such things, in
/// proportion to the floor's area. Each lies at a wall where nothing is before it, out of the way of doors, drawers,
/// openings and the front of furniture, where the agent can walk up to it (`walk`: in the scene), and comes to rest
/// there (`settle`: in physics). None without a household. How many it placed. Deterministic in rng.
int put_on_floors(Workspace& workspace, const LayoutRecipe& recipe, const Walk& walk, int wanted, bool settle, Rng rng);

}  // namespace unietp
