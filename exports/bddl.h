#pragma once

#include <optional>
#include <string>

#include "exports/behavior_goal.h"

namespace unietp {

/// A BEHAVIOR task as a BDDL problem of the domain `omnigibson`.
struct BddlProblem {
  std::string text;  // with the objects that its goal names, what they rest on or in, and the rooms of furniture
  BddlNames
      names;  // of these objects, by our ids: "apple_1/2" is the second half of one that can be cut, a room its floor
  BddlNames substances;  // that it names, by ours
  BehaviorGoal goal;     // over literals
  bool decides = true;   // whether the last state decides the goal. If not, the problem's goal is necessary, not enough
};

/// Comments of the text give our id of each object. Where BDDL's quantifiers can say the goal, it is written with them,
/// otherwise object by object. `task` has a demonstration in M1. Pure. Errors: Unsatisfiable with the reason why BDDL
/// cannot express the goal.
Result<BddlProblem> bddl_problem(const FinishedTask& task, const Knowledge& knowledge, const BddlWords& words);

}  // namespace unietp
