#pragma once

#include <map>
#include <string>
#include <vector>

#include "record/manifest_record.h"
#include "validator/database_check.h"
#include "validator/key_list.h"
#include "validator/problem.h"
#include "validator/task_reading.h"

namespace unietp {

/// How many there are of each, by name.
using NameCounts = std::map<std::string, int>;

/// What rejections.jsonl holds.
struct RejectionCounts {
  int lines = 0;
  NameCounts reasons;  // by "stage reason"
  int reviewed = 0;    // tasks that people took out
  NameCounts reviewed_splits, reviewed_simulators;
  std::vector<Problem> problems;  // lines that do not read, and candidates that are there twice
};

/// Reads rejections.jsonl. `candidates` holds the slot and attempt of each task and takes those of the rejections;
/// `tasks` are the names of the tasks.
RejectionCounts count_rejections(const std::filesystem::path& folder, KeyList& candidates, const TaskNames& tasks);

/// The slot and attempt of a candidate as a key.
Digest candidate_key(int slot, int attempt);

/// Holds the manifest's numbers and the recorded configuration against the tasks, which are added in their order.
class TaskRecount {
 public:
  explicit TaskRecount(const ManifestRecord& manifest) : manifest_(manifest) {}
  void add(const TaskReading& task);

  /// The manifest's numbers of tasks, rejections and candidates.
  std::vector<Problem> wrong_counts(const RejectionCounts& rejections) const;
  /// What the configuration asks for: the number of tasks, quotas by split and simulator, modes, templates, seed.
  std::vector<Problem> wrong_quotas(const RejectionCounts& rejections) const;
  bool all_read() const { return all_read_; }

 private:
  void check_task(const TaskReading& task);

  const ManifestRecord& manifest_;
  int tasks_ = 0;
  bool all_read_ = true;  // when a task does not read, what it is of is not known
  NameCounts splits_, simulators_, templates_;
  std::vector<Problem> quota_problems_;  // of single tasks, up to the first that does not read
};

/// The recorded spread over each dimension against that of the tasks.
std::vector<Problem> check_balance(const ManifestRecord& manifest, TraitCounts counts);

}  // namespace unietp
