#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/ordered_work.h"
#include "core/result.h"
#include "record/dataset_lines.h"
#include "record/home_shelf.h"
#include "record/task_record.h"
#include "record/wordings_record.h"
#include "scene/scene.h"

namespace unietp {

/// One task of a finished data set with what belongs to it, as far as it was asked for.
struct FinishedTask {
  TaskRecord record;
  std::map<Mode, DemonstrationRecord> shown;  // of the modes asked for
  std::optional<WordingsRecord> wordings;
  Scene start;
};

/// Reads a finished data set task by task, strictly, in memory that does not grow with it.
class DatasetReader {
 public:
  /// Errors: Io, for a file that is missing or cannot be opened.
  static Result<DatasetReader> open(const std::filesystem::path& folder, const DatasetParts& parts,
                                    FileNames names = FileNames::WithFolder);

  /// The lines of the tasks, in order; they are parsed by the functions below, which several threads may call.
  DatasetLines& lines() { return lines_; }
  const DatasetLines& lines() const { return lines_; }
  HomeShelf& homes() const { return *homes_; }

  /// Parse one of the lines, which is there. Errors: Parse with line and column; Schema with line and JSON pointer, or
  /// for wordings of another task.
  Result<TaskRecord> task(const TaskLines& lines) const;
  Result<DemonstrationRecord> demonstration(const TaskLines& lines, Mode mode) const;
  Result<WordingsRecord> wordings(const TaskLines& lines) const;
  /// Why a demonstration in a mode cannot be that of the task; nullopt when it can.
  std::optional<Error> misplaced(const TaskLines& lines, Mode mode, const DemonstrationRecord& shown,
                                 const TaskRecord& task) const;

  /// The start scene of a task. Errors: those of HomeShelf.
  Result<Scene> start(const TaskLines& lines, const TaskRecord& task) const;

  /// What is wrong with lines and with those in front of them, as far as that shows without parsing; nullopt: nothing.
  std::optional<Error> line_error(const TaskLines& lines) const;
  /// All parts of a task. Errors: the first of what is wrong with these lines and with those in front of them.
  Result<FinishedTask> read(const TaskLines& lines) const;

 private:
  DatasetReader(DatasetLines lines, DatasetParts parts, std::shared_ptr<HomeShelf> homes)
      : lines_(std::move(lines)), parts_(std::move(parts)), homes_(std::move(homes)) {}

  DatasetLines lines_;
  DatasetParts parts_;
  std::shared_ptr<HomeShelf> homes_;  // shared: it has a mutex, and the reader moves
};

/// `work` on every task of a data set, with so many threads; what it makes goes to `take` in the order of the tasks.
/// Errors: the first in that order, of the reader, of `work` or of `take`.
template <class Made>
Result<Done> for_each_task(DatasetReader reader, int threads,
                           const std::function<Result<Made>(const FinishedTask&)>& work,
                           const std::function<Result<Done>(Made&&)>& take) {
  const auto done = work_in_order<TaskLines, Result<Made>>(
      threads, [&] { return reader.lines().next(); },
      [&](const TaskLines& lines) -> Result<Made> {
        const auto task = reader.read(lines);
        return task ? work(*task) : Result<Made>(task.error());
      },
      [&](Result<Made>&& made) -> Result<Done> { return made ? take(std::move(*made)) : Result<Done>(made.error()); });
  if (!done) return done;
  if (const auto stray = reader.lines().next_stray()) return stray->error;
  return Done{};
}

}  // namespace unietp
