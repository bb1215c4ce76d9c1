#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "core/result.h"
#include "dataset/task.h"

namespace unietp {

/// A candidate's outcome as it will stand in files: what the ledger keeps and the data set is written from.
struct CandidateRecord {
  int slot = 0, attempt = 0;
  bool accepted = false;
  std::string template_name;
  // of an accepted one
  std::string task;           // line of tasks.jsonl, without its end
  std::string demonstration;  // lines of demonstrations/<mode>.jsonl, one a mode, joined by line ends
  std::string actions;        // the same lines with mode and steps alone, and of steps what was done and how it went
  std::string start_key;      // equal for equal (template, binding, start)
  std::string text_key;       // equal for equal (layout, normalised instruction)
  std::string traits;         // text of its traits (balance.h)
  // of a rejected one
  std::string rejection;  // line of rejections.jsonl
  bool operator==(const CandidateRecord&) const = default;
};

/// Pure; no clock, no order that depends on threads.
CandidateRecord record_of(const std::variant<Task, RejectedCandidate>& candidate);

/// `CandidateRecord::actions` of a demonstration's line that was written already. Errors: Parse, naming `where`, when
/// it is none.
Result<std::string> actions_of_line(std::string_view where, std::string_view line);

std::string rejection_line(const RejectedCandidate& candidate);
/// The same for a candidate that was accepted, and then turned out to repeat a task.
std::string repetition_line(const CandidateRecord& record, bool same_start);

/// Only slot, attempt, accepted, template, keys and traits.
CandidateRecord outline_of(CandidateRecord record);

/// Lower case, letters and digits only, single blanks: instructions that differ in nothing else are the same.
std::string normalised_text(std::string_view text);

}  // namespace unietp
