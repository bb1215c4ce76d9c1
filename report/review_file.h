#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "record/review_mark_record.h"

namespace unietp {

/// A person's review of a task.
struct Review {
  std::string task;
  Judgment judgment = Judgment::Accept;
  std::string instruction;  // that was judged
  std::string text;         // the corrected instruction; of an edit only
  std::string comment;
  bool operator==(const Review&) const = default;
};

/// A file that the review page saves (data/schemas/review.schema.json). Errors: Parse with line and column; Schema with
/// a JSON pointer, also when a task is judged twice.
Result<std::vector<Review>> read_reviews(std::string_view where, std::string_view text);

}  // namespace unietp
