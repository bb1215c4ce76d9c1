#include "record/review_mark_record.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "record/record_fields.h"

namespace unietp {

Result<ReviewMarkRecord> read_review_mark(std::string_view where, int line, std::string_view text) {
  static const std::vector<std::string> kVerdicts{"accept", "reject", "edit"};
  ReviewMarkRecord mark;
  const auto read = read_line(where, line, text, "unietp-review-mark/1", [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("task")) mark.task = reader.plain_name(*f);
    if (const auto f = fields.required("verdict")) {
      mark.verdict = reader.text(*f);
      if (std::find(kVerdicts.begin(), kVerdicts.end(), mark.verdict) == kVerdicts.end())
        reader.unknown_name(*f, "verdict", kVerdicts);
    }
    if (const auto f = fields.optional("before")) mark.before = reader.text(*f);
    if (const auto f = fields.required("comment")) mark.comment = text_or_empty(reader, *f);
  });
  if (!read) return read.error();
  return mark;
}

}  // namespace unietp
