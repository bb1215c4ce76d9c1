#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "simulation/digest.h"
#include "validator/key_list.h"
#include "validator/likeness_report.h"
#include "validator/nearest_tasks.h"
#include "validator/problem.h"
#include "validator/problem_list.h"
#include "validator/task_facts.h"
#include "validator/task_reading.h"

namespace unietp {

/// Finds tasks that have a start, or the words in a home, in common with an earlier one.
class RepeatSearch {
 public:
  /// The next task, by place in tasks.jsonl. Nothing is known of one whose scene does not read: its keys are "".
  void add(std::size_t place, const TaskFacts& facts);
  ProblemList problems(const TaskNames& names);

 private:
  KeyList starts_, texts_;
};

/// What must not occur in two data sets, nor anything much like it. That texts are the same is no leak by itself:
/// people ask for the same thing in the same words.
struct SetFingerprint {
  std::string folder;  // for messages
  std::uint64_t seed = 0;
  std::set<std::string> home_keys;
  ComparedSet compared;
};
/// Reads tasks, manifest and homes of a finished data set. Errors: those of reading, the first by task.
Result<SetFingerprint> print_of(const std::filesystem::path& folder, int threads);

/// Finds what a data set shares with another one, and what it has that is much alike.
class LeakSearch {
 public:
  explicit LeakSearch(SetFingerprint other);
  /// What is most alike to one task, whose record must read. Thread-safe.
  std::optional<Nearest> nearest(const TaskReading& task, const Scene& home) const;
  /// The next task. `facts` may be those of a task whose scene does not read, which has no `nearest`.
  void add(const TaskReading& task, const TaskFacts& facts, const std::optional<Nearest>& nearest);
  /// `seed`: of the run.
  ProblemList problems(std::uint64_t seed) const;
  LikenessReport likeness() const { return count_.report(); }

 private:
  SetFingerprint other_;  // without `compared`
  NearestTasks search_;
  LikenessCount count_;
  ProblemList of_tasks_;
};

}  // namespace unietp
