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
#include "record/home_cache.h"
#include "record/task_record.h"
#include "record/wordings_record.h"
#include "scene/scene.h"

namespace unietp {

/// One task of a finished data set with the parts that were requested.
struct FinishedTask {
  TaskRecord record;
  std::map<Mode, DemonstrationRecord> shown;  // of the requested modes
  std::optional<WordingsRecord> wordings;
  Scene start;
};

/// Refuses a goal whose quantifiers range over more objects of a start than can be evaluated. Errors: Schema, at
/// `where`, for more than limits::kCombinations.
Result<Done> check_combinations(const std::string& where, const Formula& goal, const Scene& start);

/// Reads a finished data set strictly, task by task. Memory use does not depend on the number of tasks.
class DatasetReader {
 public:
  /// Errors: Io, for a file that is missing or cannot be opened.
  static Result<DatasetReader> open(const std::filesystem::path& folder, const DatasetParts& parts,
                                    FileNames names = FileNames::WithFolder);

  /// The lines of the tasks, in order. The functions below parse them; several threads may call those.
  DatasetLines& lines() { return lines_; }
  /// For error messages: where a line stands.
  const DatasetLines& lines() const { return lines_; }
  /// The homes of the data set.
  HomeCache& homes() const { return *homes_; }

  /// Parse one of the lines, which must exist. Errors: Parse with line and column; Schema with line and JSON pointer,
  /// or for wordings of a different task.
  Result<TaskRecord> task(const TaskLines& lines) const;
  Result<DemonstrationRecord> demonstration(const TaskLines& lines, Mode mode) const;
  Result<WordingsRecord> wordings(const TaskLines& lines) const;
  /// Why a demonstration in a mode does not belong to the task; nullopt when it does.
  std::optional<Error> misplaced(const TaskLines& lines, Mode mode, const DemonstrationRecord& shown,
                                 const TaskRecord& task) const;

  /// The start scene of a task. Errors: those of HomeCache.
  Result<Scene> start(const TaskLines& lines, const TaskRecord& task) const;

  /// The first problem of these lines and of those before them that shows without parsing; nullopt: none.
  std::optional<Error> line_error(const TaskLines& lines) const;
  /// All requested parts of a task. Errors: the first problem of these lines or of those before them.
  Result<FinishedTask> read(const TaskLines& lines) const;

 private:
  DatasetReader(DatasetLines lines, DatasetParts parts, std::shared_ptr<HomeCache> homes)
      : lines_(std::move(lines)), parts_(std::move(parts)), homes_(std::move(homes)) {}

  DatasetLines lines_;
  DatasetParts parts_;
  std::shared_ptr<HomeCache> homes_;  // shared: it has a mutex, and the reader moves
};

/// Calls `work` for every task of a data set, with so many threads, and `take` with the results in the order of the
/// tasks. Stops at the first error in that order, of the reader, of `work` or of `take`, and returns it.
template <class Made>
Result<Done> for_each_task(DatasetReader reader, int threads,
                           const std::function<Result<Made>(const FinishedTask&)>& work,
                           const std::function<Result<Done>(Made&&)>& take) {
  auto done = work_in_order<TaskLines, Result<Made>>(
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
