#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "environment/task.h"
#include "record/task_record.h"

namespace unietp {

/// A line of the index of a data set.
struct TaskListing {
  std::string id, split, template_name, simulator, layout, instruction;
  std::vector<Mode> modes;  // that it has demonstrations of
};

/// The tasks of a finished data set, by position and by id. Opening reads every line of tasks.jsonl once, strictly;
/// homes are read and prepared when a task first needs one. Homes and tasks that were asked for are kept, a bounded
/// number of them, and shared. Thread-safe: all functions may be called from several threads at once. Copies share
/// everything.
class TaskSource {
 public:
  /// How many prepared homes and tasks are kept for reuse, the last that were asked for. Enough for all of the
  /// benchmark, with its 170 homes and 536 tasks, so that only the first round over it prepares them.
  struct Kept {
    std::size_t homes = 192, tasks = 640;
  };

  /// Errors: Io for a folder without tasks.jsonl; Parse with line and column; Schema with a JSON pointer, or for an id
  /// that two tasks have.
  static Result<TaskSource> open(const std::filesystem::path& folder, const AllSimulatorData& data, Kept kept);
  static Result<TaskSource> open(const std::filesystem::path& folder, const AllSimulatorData& data) {
    return open(folder, data, Kept());
  }

  std::size_t size() const;
  /// In the order of the file.
  const std::vector<TaskListing>& listing() const;
  /// nullopt when no task has the id.
  std::optional<std::size_t> find(std::string_view id) const;

  /// The task at a position. Errors: Usage for a position that there is none at, Io, Parse and Schema of its home and
  /// start.
  Result<SharedTask> task(std::size_t position) const;
  /// The same by id. Errors: also Usage for an id that no task has, naming the nearest.
  Result<SharedTask> task(std::string_view id) const;
  /// The stored demonstration of a task. Errors: Usage when the data set has none in that mode; Parse and Schema.
  Result<DemonstrationRecord> demonstration(std::size_t position, Mode mode) const;
  /// Its commands alone, sooner. Errors: as above.
  Result<std::vector<Command>> demonstrated_plan(std::size_t position, Mode mode) const;
  /// The modes that the data set has demonstrations of.
  const std::vector<Mode>& modes() const;

  /// All positions in an order that depends on the seed only.
  std::vector<std::size_t> order(std::uint64_t seed) const;

 private:
  template <class Record>
  Result<Record> shown(std::size_t position, Mode mode,
                       Result<Record> (*read)(std::string_view where, int line, std::string_view text)) const;

  struct Impl;
  std::shared_ptr<Impl> impl_;  // shared by copies: has a mutex and caches
};

}  // namespace unietp
