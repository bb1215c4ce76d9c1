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

/// Holds dataset.sqlite against the other files: the same tasks with the same fields, their bindings, as many steps as
/// they count, as many rejections; and the traits of each task, which are its template, its home, the rooms where what
/// is handled stands, and otherwise categories that it binds. Nothing is said of a set in which a task does not read.
class DatabaseCheck {
 public:
  explicit DatabaseCheck(const std::filesystem::path& folder);
  ~DatabaseCheck();
  DatabaseCheck(const DatabaseCheck&) = delete;
  DatabaseCheck& operator=(const DatabaseCheck&) = delete;

  /// The next task, which reads.
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
