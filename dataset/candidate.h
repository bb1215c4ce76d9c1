#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/result.h"
#include "dataset/lines.h"
#include "dataset/task.h"
#include "dataset/task_row.h"

namespace unietp {

/// A task as it is written to a data set.
struct WrittenTask {
  TaskRow row;
  std::string line;                // of tasks.jsonl
  std::vector<std::string> shown;  // lines of demonstrations/<mode>.jsonl, in the order of modes_of(row)
  bool operator==(const WrittenTask&) const = default;
};

/// The outcome of a candidate: the ledger stores it, and the data set is written from it.
struct CandidateRecord {
  int slot = 0, attempt = 0;
  bool accepted = false;
  std::string template_name;
  // of an accepted one
  WrittenTask task;
  std::string start_key;  // equal for equal (template, binding, start)
  std::string text_key;   // equal for equal (layout, normalized instruction)
  std::string traits;     // text of its traits (balance.h)
  // of a rejected one
  RejectionEntry rejection;
  bool operator==(const CandidateRecord&) const = default;
};

/// The outcome of a candidate. Pure.
CandidateRecord record_of(const std::variant<Task, RejectedCandidate>& candidate);

/// The row of a task, without its actions.
TaskRow row_of(const TaskEntry& task);
/// A step as a row of the table `step`.
ActionRow action_row(Mode mode, const StepEntry& step);

/// The rejection of an accepted candidate that repeats an earlier task.
RejectionEntry repetition_entry(const CandidateRecord& record, bool same_start);

/// Only slot, attempt, accepted, template, keys, traits and the reason of a rejection.
CandidateRecord outline_of(CandidateRecord record);

/// Lower case, letters and digits only, single blanks: instructions that differ in nothing else are the same.
std::string normalized_text(std::string_view text);

}  // namespace unietp
