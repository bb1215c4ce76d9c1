#include "record/wordings_record.h"

#include <array>

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

std::string_view name_of(WordingKind kind) {
  constexpr std::array<std::string_view, 4> kNames{"complex", "contrast", "direct", "referring"};
  return kNames[static_cast<std::size_t>(kind)];
}

Result<WordingsRecord> read_wordings(std::string_view where, int line, std::string_view text) {
  WordingsRecord record;
  const auto read = read_line(where, line, text, "unietp-wordings/1", [&](JsonReader& reader, JsonFields& fields) {
    if (const auto f = fields.required("task")) record.task = reader.plain_name(*f);
    if (const auto f = fields.required("pair")) record.pair = reader.plain_name(*f);
    using enum WordingKind;
    for (const WordingKind kind : {Direct, Referring, Complex, Contrast}) {
      const auto f = kind == Direct ? fields.required(name_of(kind)) : fields.optional(name_of(kind));
      if (f) record.wordings[kind] = read_wording(reader, *f, kind == Referring || kind == Contrast);
    }
    if (const auto f = fields.optional("others"))
      for (std::size_t i = 0; i < reader.items(*f) && !reader.error(); ++i)
        record.others.push_back(read_wording(reader, reader.item(*f, i), false));
  });
  if (!read) return read.error();
  return record;
}

}  // namespace unietp
