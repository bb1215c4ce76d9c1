#pragma once

#include <string>
#include <vector>

#include "record/task_record.h"
#include "simulation/world.h"
#include "validator/problem.h"

namespace unietp {

std::string text_of(const Edge& edge);  // "on(mug_1, table_1)"

/// Result of replaying a demonstration.
struct Replay {
  std::vector<Delta> changes;  // from moment to moment
  std::vector<Action> plan;    // the actions, with objects by their ids; without the final stop
  std::vector<Problem> problems;
};

/// Repeats the steps of a demonstration under the rules of its mode, and compares every outcome, view and change with
/// the record. Only the first difference of each kind is reported, since later ones follow from it.
Replay replay(const World& start, Mode mode, const DemonstrationRecord& demonstration, const std::string& where);

/// Steps and failures of a demonstration against those that its task counts. About the task, at `where`.
std::vector<Problem> check_step_count(const TaskRecord& task, Mode mode, const DemonstrationRecord& demonstration,
                                      const std::string& where);

}  // namespace unietp
