#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "simulation/digest.h"
#include "validator/key_list.h"
#include "validator/problem.h"
#include "validator/task_facts.h"
#include "validator/task_reading.h"

namespace unietp {

/// Finds tasks that have a start, or the words in a home, in common with an earlier one.
class RepeatSearch {
 public:
  /// The next task, by place in tasks.jsonl. Nothing is known of one whose scene does not read: its keys are "".
  void add(std::size_t place, const TaskFacts& facts);
  std::vector<Problem> problems(const TaskNames& names);

 private:
  KeyList starts_, texts_;
};

/// What must not occur in two data sets.
struct SetPrint {
  std::string folder;  // for messages
  std::uint64_t seed = 0;
  std::set<std::string> layouts, home_keys;
  std::set<std::pair<std::uint64_t, std::uint64_t>> words;  // keys of the instructions
};
/// Reads tasks, manifest and homes of a finished data set. Errors: those of reading, the first by task.
Result<SetPrint> print_of(const std::filesystem::path& folder, int threads);

/// Finds what a data set shares with another one.
class LeakSearch {
 public:
  explicit LeakSearch(SetPrint other) : other_(std::move(other)) {}
  /// The next task. `facts` may be those of a task whose scene does not read.
  void add(const TaskReading& task, const TaskFacts& facts);
  /// `seed`: of the run.
  std::vector<Problem> problems(std::uint64_t seed) const;

 private:
  SetPrint other_;
  std::vector<Problem> of_tasks_;
};

}  // namespace unietp
