#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"
#include "simulation/mode_rules.h"
#include "simulation/world.h"
#include "validator/problem.h"
#include "validator/trace_maker.h"

namespace unietp {

/// Result of running plans that must not reach the goal.
struct MustFail {
  int tried = 0;  // plans
  std::vector<Problem> problems;
};

/// Changes the plan of a demonstration and runs each changed plan under the rules of its mode: without one of its steps
/// (an object that is then not put down stays in the hand), with its parts in a different order if the goal requires an
/// order, and with an excluded object in place of each referent. Actions whose object cannot be named at that point are
/// skipped. A changed plan that reaches the goal is a problem; of the orders, one that fails is enough, since not every
/// order matters. `plan`: the actions of the demonstration, with objects by their ids.
MustFail must_fail(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces,
                   const std::vector<Action>& plan, const std::string& where);

}  // namespace unietp
