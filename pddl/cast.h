#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp::pddl {

/// The nodes that take part in a problem, in scene order: all of the categories that the goal speaks of, `handled`
/// (ids, as in a demonstration), the tools for them (a few of a category), places to put them aside, what any of these
/// rests on or in, and what can be moved and rests on or in what can be moved. The rest of a home makes no difference
/// to the shortest plan, except by standing where something else could.
std::vector<const Node*> cast_of(const Scene& scene, const Knowledge& knowledge, const Formula& goal,
                                 const std::vector<std::string>& handled);

}  // namespace unietp::pddl
