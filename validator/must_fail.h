#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"
#include "simulation/mode_rules.h"
#include "simulation/world.h"
#include "validator/problem.h"
#include "validator/trace_maker.h"

namespace unietp {

struct MustFail {
  int tried = 0;  // plans
  std::vector<Problem> problems;
};

/// Spoils the plan of a demonstration and lets each spoilt plan run under the rules of its mode: without each of its
/// steps (what is then not put down stays in the hand), with parts of it in another order where the goal asks for one,
/// and with what a referring phrase excludes in place of what it means. What cannot be named when its turn comes is
/// left out. A spoilt plan that reaches the goal is a problem; of the orders one that fails is enough, since not every
/// order matters. `plan`: what was done, with objects by their ids.
MustFail must_fail(const Formula& goal, const World& start, Mode mode, const TraceMaker& traces,
                   const std::vector<Action>& plan, const std::string& where);

}  // namespace unietp
