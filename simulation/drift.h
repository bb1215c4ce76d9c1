#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"
#include "simulation/physics.h"

namespace unietp {

/// A movable object that does not stay where it is.
struct Drift {
  std::size_t node = 0;
  double moved_m = 0;   // the distance after two seconds of physics; 1 where physics has no number
  double fallen_m = 0;  // how far down, of that
};

/// The bodies of all movable objects, in order of the nodes.
std::vector<BodyId> loose_bodies(const Scene& scene);

/// The movable objects that move by more than `allowed_m` in two seconds of physics, all released at once, in whichever
/// of two orders the solver takes the bodies: what rests in one order alone starts to creep as soon as a task adds
/// something elsewhere. In order of the nodes. `work`: what may be done; what was done is taken off, and when nothing
/// is left, less than two seconds were seen. Deterministic.
std::vector<Drift> drifting(const Scene& scene, const PhysicsWorld& world, double allowed_m, std::size_t& work);

}  // namespace unietp
