#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "record/manifest_record.h"
#include "record/task_record.h"
#include "validator/problem_list.h"

namespace unietp {

/// Checks that the tasks and rejections are all candidates of the slots that the configuration asks for, in their
/// order: a slot's attempts are counted from 0, all but the last were rejected, and all have its simulator and split. A
/// task that people took out in a review counts as one. Memory: some 70 bytes of each slot.
class CandidateCheck {
 public:
  explicit CandidateCheck(const ManifestRecord& manifest) : manifest_(manifest) {}

  /// The next task of tasks.jsonl, `name` for messages; one that could be read.
  void add(const TaskRecord& task, const std::string& name, const std::string& where);
  /// After the last task: the next line of rejections.jsonl, one that could be read.
  void add(const RejectionRecord& rejection, const std::string& where);
  /// After the last line. `complete`: all lines could be read; otherwise only the names and order of tasks are checked.
  ProblemList finish(bool complete = true);

 private:
  struct Slot {
    int rejected = 0;    // attempts, from 0
    int filled_by = -1;  // attempt of its task
    int kind = -1;       // place of its simulator and split in kinds_
  };

  void found(const std::string& where, std::string message) {
    problems_.add(problem_in(ProblemKind::Rejections, where, std::move(message)));
  }
  int kind_of(const std::string& simulator, const std::string& split);

  const ManifestRecord& manifest_;
  std::map<int, Slot> slots_;
  std::map<std::pair<std::string, std::string>, int> kinds_;
  int last_task_ = -1, last_rejected_ = -1;  // slots
  bool reviewed_ = false;
  ProblemList of_tasks_, problems_;
};

/// The id of the task in a slot: "ai2thor-00003" of slot 2.
std::string task_id_of(const std::string& simulator, int slot);

}  // namespace unietp
