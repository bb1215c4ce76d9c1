#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "exports/bddl_goal.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// A BEHAVIOR task as a BDDL problem of the domain `omnigibson`, with the objects that its goal names, what they rest
/// on or in, and the rooms of furniture. Comments give our id of each object. Pure. Errors: Unsatisfiable with the
/// reason why BDDL, which evaluates only the last state, cannot express the goal.
Result<std::string> bddl_problem(const std::string& name, const Formula& goal, const Scene& start,
                                 const Knowledge& knowledge, const BddlSynsets& synsets);

}  // namespace unietp
