#pragma once

#include "core/rng.h"
#include "grounding/workspace.h"

namespace unietp {

/// Puts movable objects on and in what the scene has, where the knowledge places them: each time a category is drawn,
/// the less often the more of it there are; then its relation and receptacle by likelihood, rather in its usual rooms;
/// then a place (find_place). Stops at `wanted` objects or after four times as many tries. How many it placed.
int scatter_objects(Workspace& workspace, int wanted, int draws_per_object, Rng rng);

/// Receptacles of the scene that the knowledge allows for an object, with weights.
struct Host {
  std::size_t node;
  Predicate relation;
  double weight;
};
std::vector<Host> hosts_for(const Workspace& workspace, const Node& object);

}  // namespace unietp
