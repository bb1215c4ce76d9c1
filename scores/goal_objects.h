#pragma once

#include <set>
#include <string>
#include <vector>

#include "environment/task.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// Things that a quantifier of a goal ranges over, at the start of the task.
struct GoalObjects {
  std::set<std::string, std::less<>> referents;  // ids of its domain
  std::set<std::string, std::less<>> alike;      // of the same categories, but excluded by its `:where`
};

/// For each quantifier over objects of the goal whose domain does not depend on another variable, in order of text.
/// Rooms, the agent, "object" and what does not exist at the start are left out.
std::vector<GoalObjects> goal_objects(const EnvironmentTask& task);
/// The same for a goal and its start, the first state of the trace.
std::vector<GoalObjects> goal_objects(const Formula& goal, const Trace& start);

}  // namespace unietp
