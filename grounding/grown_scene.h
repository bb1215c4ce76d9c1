#pragma once

#include <memory>

#include "grounding/current_state.h"
#include "grounding/home.h"
#include "scene/edge_change.h"
#include "scene/node_index.h"
#include "scene/trace.h"
#include "simulation/known_start.h"

namespace unietp {

/// A scene that grew out of a home, compared with it and read at the cost of the differences.
struct GrownScene {
  Differences changed;
  PhysicsWorld physics;  // of its bodies
  std::shared_ptr<const Walk> walk;
  NodeIndex places;
  EdgeChange edges;               // from the home's to those that read_relations gives
  CurrentState::NodeLinks links;  // of all nodes of which they may differ from the home's
  Trace now;                      // without comparisons
  FactReader reader;              // that read it
};
GrownScene read_grown(const Home& home, const Scene& scene);

/// What a world of such a scene need not work out again.
KnownStart known_start(const Home& home, const Scene& scene, GrownScene grown);

}  // namespace unietp
