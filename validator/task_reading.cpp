#include "validator/task_reading.h"

#include <algorithm>

namespace unietp {
namespace {

void read_own_wordings(const DatasetReader& reader, const TaskLines& lines, TaskReading& task) {
  auto& problems = task.wordings_problems;
  for (const StrayLine& stray : lines.strays) {
    if (!stray.mode) problems.push_back(stray_problem(stray));
  }
  if (!lines.wordings.line) {
    if (!lines.wordings.missing.message.empty()) task.missing_wordings = lines.wordings.missing;
    return;
  }
  auto wordings = reader.wordings(lines);
  if (!wordings) {
    problems.push_back({ProblemKind::Unreadable, "", wordings.error()});
  } else {
    task.wordings = std::move(*wordings);
  }
}

void find_demonstrations(const TaskLines& lines, TaskReading& task) {
  for (const Mode mode : kModes) {
    for (const StrayLine& stray : lines.strays) {
      if (stray.mode == mode) task.problems.push_back(stray_problem(stray));
    }
    if (!task.record || lines.shown_in(mode).line || !counts_steps(*task.record, mode)) continue;
    task.problems.push_back({ProblemKind::MissingDemonstration, task.name, lines.shown_in(mode).missing});
  }
}

}  // namespace

TaskReading read_task_lines(const DatasetReader& reader, const TaskLines& lines) {
  TaskReading task;
  task.where = reader.lines().task_at(lines.task.number);
  task.record = reader.task(lines);
  task.name = task.record ? task.record->id : lines.id;
  if (task.name.empty()) task.name = task.where;
  if (!task.record) task.problems.push_back({ProblemKind::Unreadable, task.name, task.record.error()});
  find_demonstrations(lines, task);
  read_own_wordings(reader, lines, task);
  return task;
}

Problem stray_problem(const StrayLine& stray) {
  if (!stray.is_sound) return {ProblemKind::Unreadable, stray.mode ? stray.task : "", stray.error};
  if (!stray.mode) return {ProblemKind::Wordings, "", stray.error};
  return {ProblemKind::StrayDemonstration, stray.task, stray.error};
}

bool counts_steps(const TaskRecord& task, Mode mode) {
  return std::any_of(task.expert.begin(), task.expert.end(), [mode](const auto& count) { return count.mode == mode; });
}

}  // namespace unietp
