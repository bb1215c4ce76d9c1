#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/share_work.h"
#include "record/home_shelf.h"
#include "record/task_record.h"
#include "scene/scene.h"
#include "validator/validation_options.h"

namespace unietp {

/// One task of a finished data set with what belongs to it.
struct FinishedTask {
  TaskRecord record;
  Scene start;
  std::map<Mode, DemonstrationRecord> shown;
};

/// The lines of one task, as they stand in the files.
struct TaskLines {
  int number = 0;  // of the line, 1-based; the same in all files
  std::string task;
  std::map<Mode, std::string> shown;
};

/// Walks through a finished data set task by task, so that memory does not grow with it: demonstrations stand in the
/// order of the tasks.
class FinishedTasks {
 public:
  /// `modes`: whose demonstrations are wanted. Errors: Io for a file that is not there.
  static Result<FinishedTasks> open(const std::filesystem::path& dataset, const std::vector<Mode>& modes);

  /// The next task's lines; nullopt after the last.
  std::optional<TaskLines> next();
  /// Reads lines strictly, with the start that they make of a home. Errors: those of read_task, read_demonstration and
  /// HomeShelf; Schema when a demonstration is another task's. May be called from several threads.
  Result<FinishedTask> read(const TaskLines& lines) const;

 private:
  FinishedTasks() = default;
  std::filesystem::path dataset_;
  std::shared_ptr<HomeShelf> homes_;
  std::ifstream tasks_;
  std::map<Mode, std::ifstream> demonstrations_;
  int number_ = 0;
};

/// The modes that a data set has demonstrations of.
std::vector<Mode> shown_modes(const std::filesystem::path& dataset);

/// Whether its agents acted by the profile `wide`: the manifest says that the extended library was taken. A manifest
/// that does not read counts as one that does not say so.
bool acted_wide(const std::filesystem::path& dataset);

/// `work` on every task, many at a time on so many threads; what it gives goes to `take` in the order of the tasks.
/// Stops at the first error in that order.
template <class T>
Result<Done> for_each_task(FinishedTasks tasks, int threads, const std::function<Result<T>(const FinishedTask&)>& work,
                           const std::function<Result<Done>(T&&)>& take);

/// The simulator's facts and limits among `backends`, which are in the order of kSimulators.
const ValidationBackend& backend_of(const std::vector<ValidationBackend>& backends, const Scene& scene);

template <class T>
Result<Done> for_each_task(FinishedTasks tasks, int threads, const std::function<Result<T>(const FinishedTask&)>& work,
                           const std::function<Result<Done>(T&&)>& take) {
  constexpr std::size_t kAtOnce = 64;  // bounds the memory, and keeps the threads busy
  for (bool more = true; more;) {
    std::vector<TaskLines> lines;
    while (lines.size() < kAtOnce) {
      auto next = tasks.next();
      if (!next) break;
      lines.push_back(std::move(*next));
    }
    more = lines.size() == kAtOnce;
    std::vector<std::optional<Result<T>>> made(lines.size());
    share_work(threads, lines.size(), [&](std::size_t i) {
      const auto task = tasks.read(lines[i]);
      made[i] = task ? work(*task) : Result<T>(task.error());
    });
    for (auto& one : made) {
      if (!*one) return one->error();
      if (auto taken = take(std::move(**one)); !taken) return taken.error();
    }
  }
  return Done{};
}

}  // namespace unietp
