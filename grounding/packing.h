#pragma once

#include <vector>

#include "scene/geometry.h"
#include "simulation/collider.h"

namespace unietp {

/// A thing and the poses, W, at which it could be let go.
struct ObjectWithPoses {
  const Collider* collider = nullptr;
  std::vector<Pose> spots;
};

/// Whether each can have one of its spots so that no two of them overlap. Where the search grows long it is broken off,
/// and the answer is yes. Deterministic.
bool fit_together(const std::vector<ObjectWithPoses>& things);

}  // namespace unietp
