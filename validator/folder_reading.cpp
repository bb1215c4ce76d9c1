#include "validator/folder_reading.h"

#include <algorithm>

#include "core/files.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;
using LineOfTask = std::map<std::string, std::size_t, std::less<>>;

/// The task that a line names in one of its first fields, without reading all of it; "" when it does not say.
std::string named_in(std::string_view line, std::string_view quoted_field = "\"task\":") {
  const auto field = line.substr(0, 400).find(quoted_field);
  if (field == std::string_view::npos) return "";
  const auto open = line.find('"', field + quoted_field.size());
  const auto close = open == std::string_view::npos ? open : line.find('"', open + 1);
  return close == std::string_view::npos ? "" : std::string(line.substr(open + 1, close - open - 1));
}

LineOfTask lines_by_task(const LineFile& file, std::vector<Problem>& problems) {
  LineOfTask lines;
  for (std::size_t i = 0; i < file.size(); ++i) {
    auto task = named_in(file.line(i));
    if (task.empty() || lines.emplace(task, i).second) continue;
    problems.push_back(
        problem_in(ProblemKind::StrayDemonstration, file.at(i), "is a second demonstration of this task"));
    problems.back().task = std::move(task);
  }
  return lines;
}

bool counts(const TaskRecord& task, Mode mode) {
  return std::any_of(task.expert.begin(), task.expert.end(), [mode](const auto& count) { return count.mode == mode; });
}

/// Finds a task's demonstration: by name, or, where no line has its name, on its own line if that names nobody.
void find_demonstration(TaskReading& task, std::size_t index, Mode mode, const LineFile& file, const LineOfTask& lines,
                        std::vector<Problem>& problems) {
  if (!counts(*task.record, mode)) return;
  auto& shown = task.shown[static_cast<std::size_t>(mode)];
  if (const auto named = lines.find(task.name); named != lines.end()) {
    shown = named->second;
  } else if (index < file.size() && named_in(file.line(index)).empty()) {
    shown = index;
  } else {
    problems.push_back(problem_in(ProblemKind::MissingDemonstration, file.name(), "has no demonstration of this task"));
    problems.back().task = task.name;
  }
}

/// Demonstrations of no task, or of one that counts no steps for the mode.
void find_strays(const FolderReading& set, Mode mode, const LineOfTask& lines,
                 const std::map<std::string_view, const TaskReading*>& tasks, std::vector<Problem>& problems) {
  const LineFile& file = set.demonstrations[static_cast<std::size_t>(mode)];
  for (const auto& [name, line] : lines) {
    const auto task = tasks.find(name);
    if (task != tasks.end() && (!task->second->record || counts(*task->second->record, mode))) continue;
    problems.push_back(problem_in(
        ProblemKind::StrayDemonstration, file.at(line),
        task == tasks.end() ? "belongs to no task in tasks.jsonl" : "is in a mode that its task does not list"));
    problems.back().task = name;
  }
  for (std::size_t i = set.tasks.size(); i < file.size(); ++i) {
    if (named_in(file.line(i)).empty())
      problems.push_back(problem_in(ProblemKind::StrayDemonstration, file.at(i), "names no task"));
  }
}

}  // namespace

std::string demonstrations_file(Mode mode) { return "demonstrations/" + std::string(name_of(mode)) + ".jsonl"; }

Result<LineFile> LineFile::read(const fs::path& folder, std::string name) {
  LineFile file;
  file.name_ = std::move(name);
  if (std::error_code code; !fs::exists(folder / file.name_, code)) return file;
  auto bytes = read_file(folder / file.name_);
  if (!bytes) return bytes.error();
  file.bytes_ = std::move(*bytes);
  for (std::size_t start = 0; start < file.bytes_.size();) {
    file.starts_.push_back(start);
    const auto end = file.bytes_.find('\n', start);
    start = end == std::string::npos ? file.bytes_.size() : end + 1;
  }
  if (!file.starts_.empty()) file.starts_.push_back(file.bytes_.size());
  return file;
}

std::string_view LineFile::line(std::size_t index) const {
  std::string_view text(bytes_.data() + starts_[index], starts_[index + 1] - starts_[index]);
  if (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  return text;
}

Result<DemonstrationRecord> FolderReading::demonstration(Mode mode, std::size_t line) const {
  const LineFile& file = demonstrations[static_cast<std::size_t>(mode)];
  return read_demonstration(file.name(), static_cast<int>(line) + 1, file.line(line));
}

Result<FolderReading> read_folder(const fs::path& folder, std::vector<Problem>& problems) {
  FolderReading set;
  set.folder = folder;
  constexpr const char* kTasks = "tasks.jsonl";
  if (std::error_code code; !fs::exists(folder / kTasks, code))
    return Error{Error::Kind::Io, kTasks, {}, "is missing; it should list the tasks of the data set"};
  auto task_lines = LineFile::read(folder, kTasks);
  if (!task_lines) return task_lines.error();
  set.task_lines = std::move(*task_lines);
  std::array<LineOfTask, kModes.size()> lines;
  for (const Mode mode : kModes) {
    const auto index = static_cast<std::size_t>(mode);
    auto file = LineFile::read(folder, demonstrations_file(mode));
    if (!file) return file.error();
    set.demonstrations[index] = std::move(*file);
    lines[index] = lines_by_task(set.demonstrations[index], problems);
  }
  std::map<std::string_view, const TaskReading*> by_name;
  set.tasks.resize(set.task_lines.size());
  for (std::size_t i = 0; i < set.tasks.size(); ++i) {
    TaskReading& task = set.tasks[i];
    task.where = set.task_lines.at(i);
    task.record = read_task(kTasks, static_cast<int>(i) + 1, set.task_lines.line(i));
    task.name = task.record ? task.record->id : named_in(set.task_lines.line(i), "\"id\":");
    if (task.name.empty()) task.name = task.where;
    if (!task.record) {
      problems.push_back({ProblemKind::Unreadable, task.name, task.record.error()});
    } else {
      for (const Mode mode : kModes) {
        const auto index = static_cast<std::size_t>(mode);
        find_demonstration(task, i, mode, set.demonstrations[index], lines[index], problems);
      }
    }
    if (by_name.emplace(task.name, &task).second) continue;
    problems.push_back(problem_in(ProblemKind::RepeatedTask, task.where, "an earlier task has the same id"));
    problems.back().task = task.name;
  }
  for (const Mode mode : kModes) find_strays(set, mode, lines[static_cast<std::size_t>(mode)], by_name, problems);
  return set;
}

}  // namespace unietp
