#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "simulation/physics.h"

namespace unietp {

/// Lets all that is loose in a scene go, and tells what does not stay. Things that do not touch one another are let go
/// by themselves, among what is near; what was found of them is remembered by everything that physics was given, so
/// that homes which several tasks share are let go once. Thread-safe; what is told does not depend on what was asked
/// before.
class RestCheck {
 public:
  /// `moved_m`: how far something may move, metres.
  explicit RestCheck(double moved_m);
  RestCheck(const RestCheck&) = delete;
  RestCheck& operator=(const RestCheck&) = delete;
  ~RestCheck();

  struct Moved {
    std::size_t node = 0;  // place in Scene::nodes
    double distance_m = 0;
  };
  /// In the order of the nodes; `physics` is that of the scene.
  std::vector<Moved> of(const Scene& scene, const PhysicsWorld& physics);

 private:
  struct Memory;
  double moved_m_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace unietp
