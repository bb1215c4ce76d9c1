#pragma once

#include <optional>
#include <vector>

#include "scene/node_index.h"
#include "scene/trace.h"
#include "simulation/navigation.h"
#include "simulation/physics.h"
#include "simulation/relations.h"

namespace unietp {

/// A scene in the logic, without comparisons.
struct ReadScene {
  FactReader reader;  // that read it
  Facts facts;
};

/// What is known of a start scene already, so that a world of it need not work it out again.
struct KnownStart {
  PhysicsWorld physics;                                   // as physics_of gives it
  std::optional<std::vector<std::vector<Link>>> links{};  // by node, as links_of gives them
  std::optional<NavigationGrid> grid{};                   // of the scene
  std::optional<NodeIndex> places{};                      // of its nodes
  std::optional<ReadScene> read{};
};

}  // namespace unietp
