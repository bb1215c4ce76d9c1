#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "record/dataset_reader.h"
#include "validator/problem.h"

namespace unietp {

/// The lines of one task, parsed as far as possible.
struct TaskReading {
  std::string name;   // the task's id; if the line cannot be parsed, the id in its text or `where`
  std::string where;  // "tasks.jsonl:3"
  Result<TaskRecord> record = Error{};
  std::optional<WordingsRecord> wordings;
  std::optional<Error> missing_wordings;   // of a data set that has some
  std::vector<Problem> problems;           // of the lines of this task
  std::vector<Problem> wordings_problems;  // of the data set
};

/// Parses the task and its wordings. Lines that cannot be parsed, are missing or belong to no task become problems.
/// Demonstrations are parsed later, in prove_task.
TaskReading read_task_lines(const DatasetReader& reader, const TaskLines& lines);

/// A line that belongs to no task.
Problem stray_problem(const StrayLine& stray);

/// Whether a task states steps for a mode.
bool counts_steps(const TaskRecord& task, Mode mode);

}  // namespace unietp
