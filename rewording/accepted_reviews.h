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

namespace unietp {

/// What will stand in place of a task.
struct AcceptedReview {
  const Review* review = nullptr;        // that is taken over
  bool of_person = false;                // the present text is by a person
  std::optional<Instruction> rewritten;  // of an edit
};
using AcceptedReviews = std::map<std::string, AcceptedReview>;  // by task; those whose review is taken over

/// What became of the verdicts.
struct ApplyReport {
  int accepted = 0, rejected = 0, edited = 0;
  std::vector<std::pair<std::string, std::string>> refused;  // task, why its verdict was not taken over
};

/// What the verdicts are about, and what they are held against.
struct ReviewContext {
  const std::filesystem::path& folder;
  const Resources& resources;
  English english = English::Us;                                 // of the data set
  bool accept_unchecked = false;                                 // take edits whose text does not pass the checks, too
  const std::map<std::string, ReviewMarkRecord>& judged_before;  // earlier verdicts, by task
};

/// The rulings on the tasks of a folder. What is not taken over is counted and named in the report. In memory are the
/// tasks that have a review, and the texts of the homes in which one is to be edited. Errors: those of reading.
Result<AcceptedReviews> accept_reviews(const std::vector<Review>& reviews, const ReviewContext& context,
                                       ApplyReport& report);

}  // namespace unietp
