#pragma once

#include <memory>

#include "simulation/navigation.h"
#include "simulation/ripple.h"

namespace unietp {

/// Where a body can stand in a scene, and which of it the agent can walk to from where it stands.
struct Walk {
  NavigationGrid grid;
  CellSet reached;
  std::shared_ptr<const Ripple> steps{};  // from there, finished; only of a scene that many others grow out of
};

}  // namespace unietp
