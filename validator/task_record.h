#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"
#include "logic/formula.h"
#include "scene/action.h"
#include "scene/trace.h"
#include "simulation/world.h"

namespace unietp {

/// A line of tasks.jsonl as far as it can be proven.
struct TaskRecord {
  std::string id, template_name, split, simulator, scene;
  std::string goal_text;
  Formula goal_tree;
  std::vector<std::string> start_constraints;
  std::string instruction;
  int steps = 0, failures = 0;  // of the M1 demonstration
};

/// Reads every field strictly. Errors: Parse with line and column; Schema with a JSON pointer for a missing, unknown or
/// mistyped field. `where` is the file's name; `line` the line's number in it.
Result<TaskRecord> read_task(std::string_view where, int line, std::string_view text);

/// A step of a demonstration line.
struct StepRecord {
  Action action;
  bool success = false;
  std::string failure, feedback;
  std::vector<VisibleObject> visible;
  Delta changes;
};
struct DemonstrationRecord {
  std::string task, mode;
  std::vector<StepRecord> steps;
};
Result<DemonstrationRecord> read_demonstration(std::string_view where, int line, std::string_view text);

}  // namespace unietp
