#pragma once

#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "exports/bddl_goal.h"
#include "logic/formula.h"
#include "scene/scene.h"

namespace unietp {

/// A task of BEHAVIOR as a BDDL problem of the domain `omnigibson`, with the objects that its goal speaks of, what they
/// rest on or in, and the rooms of furniture. Comments before it say which object of ours each is. Pure. Errors:
/// Unsatisfiable with the reason, in words, where BDDL does not say the goal: it reads the last state alone.
Result<std::string> bddl_problem(const std::string& name, const Formula& goal, const Scene& start,
                                 const Knowledge& knowledge, const BddlSynsets& synsets);

}  // namespace unietp
