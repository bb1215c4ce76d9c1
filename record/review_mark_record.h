#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace unietp {

/// A line of reviews.jsonl: a person's verdict that is in force.
struct ReviewMarkRecord {
  std::string task, verdict;  // verdict: "accept", "reject" or "edit"
  std::string before;         // the instruction that an edit replaced; "" where it did not
  std::string comment;        // may be empty
};
/// Errors: Parse with line and column; Schema with line and JSON pointer.
Result<ReviewMarkRecord> read_review_mark(std::string_view where, int line, std::string_view text);

}  // namespace unietp
