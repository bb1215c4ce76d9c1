#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "record/trait_table.h"
#include "validator/problem.h"
#include "validator/task_facts.h"
#include "validator/task_reading.h"

namespace unietp {

/// Compares dataset.sqlite with the other files: the tasks with their fields, the numbers of bindings, steps and
/// rejections, and the traits of each task, which must be its template, its home, the rooms of handled objects, or
/// categories that it binds.
class DatabaseCheck {
 public:
  explicit DatabaseCheck(const std::filesystem::path& folder);
  ~DatabaseCheck();
  DatabaseCheck(const DatabaseCheck&) = delete;
  DatabaseCheck& operator=(const DatabaseCheck&) = delete;

  /// The next task, in the order of tasks.jsonl; one that could be read.
  void add(const TaskReading& task, const TaskFacts& facts);
  /// After the last task. `rejections`: the number of lines of rejections.jsonl.
  std::vector<Problem> finish(std::int64_t rejections);
  /// How many tasks have each value of each dimension, by the database.
  const TraitCounts& traits() const { return traits_; }

 private:
  struct Tables;
  void fail(const std::string& reason);

  std::unique_ptr<Tables> tables_;  // null when the database does not read
  TraitCounts traits_;
  std::int64_t tasks_ = 0, rows_ = 0, bindings_ = 0, steps_ = 0;
  std::vector<Problem> problems_;
};

}  // namespace unietp
