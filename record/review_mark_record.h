#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace unietp {

class JsonReader;
struct JsonAt;

/// The verdict of a reviewer.
enum class Judgment { Accept, Reject, Edit };
std::string_view name_of(Judgment judgment);  // "accept"
/// The judgment of this name. Another text is an error of the reader, and Accept.
Judgment read_judgment(JsonReader& reader, const JsonAt& at);

/// A line of reviews.jsonl: a person's verdict that is in force.
struct ReviewMarkRecord {
  std::string task;
  Judgment verdict = Judgment::Accept;
  std::string before;   // the instruction that an edit replaced; "" where it did not
  std::string comment;  // may be empty
};
/// Errors: Parse with line and column; Schema with line and JSON pointer.
Result<ReviewMarkRecord> read_review_mark(std::string_view where, int line, std::string_view text);

}  // namespace unietp
