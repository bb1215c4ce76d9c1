#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"
#include "simulation/world.h"
#include "validator/problem.h"
#include "validator/task_record.h"
#include "validator/trace_maker.h"

namespace unietp {

struct MustFail {
  int tried = 0;  // plans
  std::vector<Problem> problems;
};

/// Spoils the plan of a demonstration in M1 and lets each spoilt plan run: without each of its steps (what is then not
/// put down stays in the hand), with parts of it in another order where the goal asks for one, and with what a
/// referring phrase excludes in place of what it means. A spoilt plan that reaches the goal is a problem; of the orders
/// one that fails is enough, since not every order matters.
MustFail must_fail(const Formula& goal, const World& start, const TraceMaker& traces,
                   const DemonstrationRecord& demonstration, const std::string& where);

}  // namespace unietp
