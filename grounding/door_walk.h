#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "grounding/reachability.h"
#include "scene/scene.h"
#include "simulation/profile.h"

namespace unietp {

/// The walk of a scene in which some pieces of furniture moved their doors, from that of the scene before: which cells
/// are reached is what a walk of the whole would say; the steps to them are those of before, 0 where none led. Looks
/// around the doors alone, unless they part what belonged together. `moved`: places in both lists of nodes.
std::shared_ptr<const Walk> walk_with_doors(const std::shared_ptr<const Walk>& before, const Scene& was,
                                            const Scene& now, const std::vector<std::size_t>& moved,
                                            const Profile& profile);

}  // namespace unietp
