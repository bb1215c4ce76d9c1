#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "record/dataset_reader.h"
#include "validator/problem.h"

namespace unietp {

/// A line of tasks.jsonl that was read, as far as that was possible.
struct TaskReading {
  std::string name;   // the task's id, or the best guess at it where the line does not read
  std::string where;  // "tasks.jsonl:3"
  Result<TaskRecord> record = Error{};
  std::optional<WordingsRecord> wordings;
  std::optional<Error> missing_wordings;   // of a data set that has some
  std::vector<Problem> problems;           // of the lines of this task
  std::vector<Problem> wordings_problems;  // of the data set
};

/// Reads the lines of one task. What cannot be read, is missing or is of no task is a problem; a demonstration is
/// parsed where it is proven.
TaskReading read_task_lines(const DatasetReader& reader, const TaskLines& lines);

/// A line that belongs to no task.
Problem stray_problem(const StrayLine& stray);

/// Whether a task states steps for a mode.
bool counts_steps(const TaskRecord& task, Mode mode);

}  // namespace unietp
