#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "scene/node_index.h"
#include "scene/trace.h"
#include "simulation/link_table.h"
#include "simulation/physics.h"
#include "simulation/view.h"
#include "simulation/walk.h"

namespace unietp {

/// The logical facts of a scene, without comparisons.
struct ReadScene {
  FactReader reader;  // that read it
  Facts facts;
};

/// What has already been computed for a start scene, so that World::create need not compute it again.
struct KnownStart {
  PhysicsWorld physics;              // as physics_of gives it
  std::optional<LinkTable> links{};  // of the nodes, while the agent holds nothing
  std::optional<SharedList<std::shared_ptr<const Collider>>> colliders{};  // by node
  std::shared_ptr<const Walk> walk{};                                      // of the scene
  std::optional<NodeIndex> places{};                                       // of its nodes
  std::optional<ReadScene> read{};
  std::optional<Viewer> viewer{};  // for its rooms
};

}  // namespace unietp
