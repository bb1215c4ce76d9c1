#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp::pddl {

/// The nodes to include in a problem, in scene order: all of the goal's categories, `handled` (ids, as in a
/// demonstration), tools for these (a few per category), places to put them aside, everything that any of these rests
/// on or in, and movable things that rest on or in movable things. Other nodes do not change the shortest plan, except
/// by taking up space.
std::vector<const Node*> problem_objects(const Scene& scene, const Knowledge& knowledge, const Formula& goal,
                                         const std::vector<std::string>& handled);

}  // namespace unietp::pddl
