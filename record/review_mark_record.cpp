#include "record/review_mark_record.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "record/record_fields.h"

namespace unietp {
namespace {

constexpr std::array<std::string_view, 3> kJudgments{"accept", "reject", "edit"};

}  // namespace

std::string_view name_of(Judgment judgment) { return kJudgments[static_cast<std::size_t>(judgment)]; }

Judgment read_judgment(JsonReader& reader, const JsonAt& at) {
  const auto name = reader.text(at);
  const auto* const found = std::find(kJudgments.begin(), kJudgments.end(), name);
  if (found != kJudgments.end()) return static_cast<Judgment>(found - kJudgments.begin());
  reader.unknown_name(at, "verdict", {kJudgments.begin(), kJudgments.end()});
  return Judgment::Accept;
}

Result<ReviewMarkRecord> read_review_mark(std::string_view where, int line, std::string_view text) {
  ReviewMarkRecord mark;
  const auto read = read_line(where, line, text, "unietp-review-mark/1", [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("task")) mark.task = reader.plain_name(*f);
    if (const auto f = fields.required("verdict")) mark.verdict = read_judgment(reader, *f);
    if (const auto f = fields.optional("before")) mark.before = reader.text(*f);
    if (const auto f = fields.required("comment")) mark.comment = text_or_empty(reader, *f);
  });
  if (!read) return read.error();
  return mark;
}

}  // namespace unietp
