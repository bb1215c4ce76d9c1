#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "record/manifest_record.h"
#include "record/trait_table.h"
#include "validator/key_list.h"
#include "validator/problem_list.h"
#include "validator/task_reading.h"

namespace unietp {

/// What the balance of a data set is measured over, in order.
inline constexpr std::array<std::string_view, 5> kDimensions{"template", "category", "receptacle", "room", "scene"};

/// Numbers by name.
using NameCounts = std::map<std::string, int>;

/// Numbers from rejections.jsonl.
struct RejectionCounts {
  int lines = 0;
  NameCounts reasons;  // by "stage reason"
  int reviewed = 0;    // tasks that people took out
  NameCounts reviewed_splits, reviewed_simulators;
  bool all_read = true;
  ProblemList problems;  // lines that cannot be read, and candidates that occur twice
};

/// Reads rejections.jsonl. `candidates` holds the slot and attempt of each task and takes those of the rejections;
/// `tasks` are the names of the tasks. `on_line` gets each line that can be read, with its place for messages.
RejectionCounts count_rejections(const std::filesystem::path& folder, KeyList& candidates, const TaskNames& tasks,
                                 const std::function<void(const RejectionRecord&, const std::string&)>& on_line);

/// The slot and attempt of a candidate as a key.
Digest candidate_key(int slot, int attempt);

/// Compares the manifest's numbers and the recorded configuration with the tasks, which are added in their order.
class TaskRecount {
 public:
  explicit TaskRecount(const ManifestRecord& manifest) : manifest_(manifest) {}
  void add(const TaskReading& task);  // counts what it has

  /// Problems with the manifest's numbers of tasks, rejections and candidates.
  ProblemList wrong_counts(const RejectionCounts& rejections) const;
  /// Problems with what the configuration requires: the number of tasks, quotas by split and simulator, modes,
  /// templates, seed.
  ProblemList wrong_quotas(const RejectionCounts& rejections) const;
  /// Problems with what the manifest says of the writers of the instructions. `edited`: texts by people, or removed
  /// tasks, which it counts as they were before.
  std::vector<Problem> wrong_writers(int edited) const;
  /// Whether every task could be read, so that the counts are complete.
  bool all_read() const { return all_read_; }

 private:
  void check_task(const TaskReading& task);

  const ManifestRecord& manifest_;
  int tasks_ = 0;
  bool all_read_ = true;  // false: split, simulator and template of some task are not known
  NameCounts splits_, simulators_, templates_, grades_, forms_, not_usual_, writers_;
  ProblemList quota_problems_;  // of single tasks, up to the first that cannot be read
};

/// Problems with the manifest's balance figures. `counts`: of the tasks.
std::vector<Problem> check_balance(const ManifestRecord& manifest, TraitCounts counts);

}  // namespace unietp
