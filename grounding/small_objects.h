#pragma once

#include "core/rng.h"
#include "grounding/recipe.h"
#include "grounding/workspace.h"

namespace unietp {

/// How many small objects are placed.
struct ScatterOptions {
  int wanted = 60;            // movable objects
  int draws_per_object = 40;  // poses tried for one
  bool settle = true;         // let each fall until it rests; else it stays a hair over what it lies on
};

/// Puts movable objects on and in what the scene has. Which ones: for each room, those that the recipe's rules name for
/// its type, in numbers in proportion to their means (at most half as many again), and a share of categories without a
/// rule; then, while there are too few, others that the knowledge calls usual in a room. Where: on or in a receptacle
/// of that room by the knowledge's likelihood, the less likely the more it carries already; tableware and books that
/// are put away mostly in a row of three or four of a kind. Stops at `wanted` objects or after twice as many tries
/// more. How many it placed.
int scatter_objects(Workspace& workspace, const LayoutRecipe& recipe, const ScatterOptions& options, Rng rng);

/// Receptacles of the scene that the knowledge allows for an object, with weights.
struct Host {
  std::size_t node;
  Predicate relation;
  double weight;
};
/// By category of the receptacle, then in the order of nodes, `on` before `inside`.
std::vector<Host> hosts_for(const Workspace& workspace, const Node& object);

}  // namespace unietp
