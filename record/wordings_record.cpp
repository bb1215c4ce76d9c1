#include "record/wordings_record.h"

#include <nlohmann/json.hpp>

#include "record/record_fields.h"

namespace unietp {
namespace {

WordingRecord read_wording(JsonReader& reader, const JsonAt& at, bool refers) {
  WordingRecord wording;
  JsonFields fields(reader, at);
  if (const auto f = fields.required("text")) wording.text = reader.line(*f);
  if (const auto f = fields.required("writer")) wording.writer = reader.text(*f);
  if (const auto f = fields.required("style")) wording.style = reader.text(*f);
  if (const auto f = fields.required("checks")) wording.checks = reader.texts(*f);
  if (const auto f = fields.optional("why")) wording.fallback = reader.text(*f);
  if (refers) {
    if (const auto f = fields.required("goal")) wording.goal = reader.line(*f);
  }
  fields.finish();
  return wording;
}

}  // namespace

Result<WordingsRecord> read_wordings(std::string_view where, int line, std::string_view text) {
  WordingsRecord record;
  const auto read = read_line(where, line, text, "unietp-wordings/1", [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("task")) record.task = reader.plain_name(*f);
    if (const auto f = fields.required("pair")) record.pair = reader.plain_name(*f);
    if (const auto f = fields.required("direct")) record.wordings["direct"] = read_wording(reader, *f, false);
    if (const auto f = fields.optional("referring")) record.wordings["referring"] = read_wording(reader, *f, true);
    if (const auto f = fields.optional("complex")) record.wordings["complex"] = read_wording(reader, *f, false);
    if (const auto f = fields.optional("contrast")) record.wordings["contrast"] = read_wording(reader, *f, true);
    if (const auto f = fields.optional("others"))
      for (std::size_t i = 0; i < reader.items(*f) && !reader.error(); ++i)
        record.others.push_back(read_wording(reader, reader.item(*f, i), false));
  });
  if (!read) return read.error();
  return record;
}

}  // namespace unietp
