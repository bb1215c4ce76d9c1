#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "annotator/instruction.h"
#include "record/review_mark_record.h"
#include "report/review_file.h"
#include "resources/resources.h"
#include "rewording/worded_task.h"

namespace unietp {

/// What will stand in place of a task.
struct Ruling {
  const Review* review = nullptr;        // that is taken over
  std::optional<Instruction> rewritten;  // of an edit
};

/// What became of the verdicts.
struct ApplyReport {
  int accepted = 0, rejected = 0, edited = 0;
  std::vector<std::pair<std::string, std::string>> refused;  // task, why its verdict was not taken over
};

/// What the verdicts are about, and what they are held against.
struct RulingContext {
  const std::filesystem::path& folder;
  const Resources& resources;
  bool accept_unchecked = false;                                 // take edits whose text does not pass the checks, too
  const std::map<std::string, ReviewMarkRecord>& judged_before;  // earlier verdicts, by task
};

/// A ruling for each task, in their order. What is not taken over is counted and named in the report. Errors: those of
/// reading a start.
Result<std::vector<Ruling>> rule_on(const std::vector<Review>& reviews, const std::vector<WordedTask>& tasks,
                                    const RulingContext& context, ApplyReport& report);

}  // namespace unietp
