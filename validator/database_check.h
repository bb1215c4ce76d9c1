#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "record/trait_table.h"
#include "validator/problem_list.h"
#include "validator/task_facts.h"
#include "validator/task_reading.h"

namespace unietp {

/// Compares dataset.sqlite with the other files: its tables, and every row and column of them in their order. The
/// traits of a task must be its template, its home, the types of rooms of handled objects and the categories that it
/// binds.
class DatabaseCheck {
 public:
  explicit DatabaseCheck(const std::filesystem::path& folder);
  ~DatabaseCheck();
  DatabaseCheck(const DatabaseCheck&) = delete;
  DatabaseCheck& operator=(const DatabaseCheck&) = delete;

  /// The next task, in the order of tasks.jsonl; one that could be read.
  void add(const TaskReading& task, const TaskFacts& facts);
  /// After the last task: the next line of rejections.jsonl, one that could be read.
  void add(const RejectionRecord& rejection);
  /// After the last line.
  ProblemList finish();
  /// How many tasks have each value of each dimension, by the database.
  const TraitCounts& traits() const { return traits_; }

 private:
  struct Tables;
  void fail(const std::string& reason);

  std::unique_ptr<Tables> tables_;  // null when the database does not read
  TraitCounts traits_;
  std::int64_t tasks_ = 0, rejections_ = 0;
  ProblemList problems_;
};

}  // namespace unietp
