#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "simulation/physics.h"

namespace unietp {

/// Releases all loose objects of a scene in physics and finds those that move. Groups of objects that do not touch one
/// another are simulated separately, among the fixed objects nearby; results are stored by a digest of all inputs of
/// the simulation, so that a home of several tasks is simulated once. Thread-safe; results do not depend on earlier
/// calls.
class RestCheck {
 public:
  /// `moved_m`: how far an object may move, meters.
  explicit RestCheck(double moved_m);
  RestCheck(const RestCheck&) = delete;
  RestCheck& operator=(const RestCheck&) = delete;
  ~RestCheck();

  /// An object that moved.
  struct Moved {
    std::size_t node = 0;  // place in Scene::nodes
    double distance_m = 0;
  };
  /// The objects that move farther than that, in the order of the nodes; `physics` is that of the scene.
  std::vector<Moved> of(const Scene& scene, const PhysicsWorld& physics);

 private:
  struct Memory;
  double moved_m_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace unietp
