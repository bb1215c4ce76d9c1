#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "report/review_file.h"
#include "resources/resources.h"
#include "rewording/accepted_reviews.h"

namespace unietp {

/// How verdicts are applied.
struct ApplyOptions {
  bool accept_unchecked = false;  // take edits whose text does not pass the checks, too
  bool keep_rejected = false;     // mark rejected tasks and leave them in
  std::filesystem::path licenses;
};

/// Writes the data set in `folder` anew as people judged it, to `out` (which may be `folder`: it is replaced at once).
/// Each verdict is kept in reviews.jsonl. A rejected task becomes a rejection of the stage `review`, so that the
/// numbers of the manifest still add up. An edit takes the place of the instruction when it reads back as the goal, in
/// the style of the task, and no other task of the home has it; its writer is `person`, or `person:unchecked`. A
/// verdict on another text than the task has now is refused; one that is in force already changes nothing.
/// Deterministic. Errors: Io; Parse, Schema of a file; Usage, when `resources` are not those the data set was made
/// with.
Result<ApplyReport> apply_review(const std::filesystem::path& folder, const std::filesystem::path& out,
                                 const std::vector<Review>& reviews, const Resources& resources,
                                 const ApplyOptions& options);

}  // namespace unietp
