#pragma once

#include <memory>

#include "simulation/distance_field.h"
#include "simulation/navigation.h"

namespace unietp {

/// Where a body can stand in a scene, and the cells that the agent can walk to from its position.
struct Walk {
  NavigationGrid grid;
  CellSet reached;
  std::shared_ptr<const DistanceField> steps{};  // from there, complete; only of a home that many starts are made from
};

}  // namespace unietp
