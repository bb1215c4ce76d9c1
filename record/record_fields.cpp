#include "record/record_fields.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "scene/json_parse.h"
#include "scene/scene_json.h"

namespace unietp {

using Json = nlohmann::ordered_json;

void read_format(JsonReader& reader, JsonFields& fields, std::string_view expected) {
  if (const auto f = fields.required("format")) {
    const auto format = reader.text(*f);
    if (format != expected)
      reader.fail(*f, "expected the format " + in_quotes(expected) + ", not " + in_quotes(format));
  }
}

Result<Json> parse_json_line(std::string_view where, int line, std::string_view text,
                             std::span<const std::string_view> left_out) {
  auto json = parse_json_without(left_out, where, text);
  if (json) return json;
  Error error = json.error();
  error.pos = {line, error.pos.column > 0 ? error.pos.column : 1};
  return error;
}

std::string text_or_empty(JsonReader& reader, const JsonAt& at) {
  const auto* text = at.json.get_ptr<const Json::string_t*>();
  return text != nullptr && text->empty() ? std::string() : reader.text(at);
}

std::vector<Delta> read_moments(JsonReader& reader, const JsonAt& at) {
  std::vector<Delta> moments;
  const std::size_t count = reader.items(at);
  for (std::size_t i = 0; i < count && !reader.error(); ++i) {
    const JsonAt item = reader.item(at, i);
    moments.push_back(read_part(reader, item, delta_from_json, item.json));
  }
  if (count < 2 && !reader.error()) reader.fail(at, "expected two or more moments");
  return moments;
}

namespace {

/// 0 and an error for what is no whole number from 0 to `high`, written so in the message.
double whole(JsonReader& reader, const JsonAt& at, double high, std::string_view high_text) {
  const double value = reader.number(at);
  if (reader.error()) return 0;
  const bool fits = value >= 0 && value <= high && value == std::floor(value);
  if (!fits) reader.fail(at, "expected a whole number from 0 to " + std::string(high_text));
  return fits ? value : 0;
}

}  // namespace

int read_whole(JsonReader& reader, const JsonAt& at) { return static_cast<int>(whole(reader, at, 1e9, "1e9")); }

std::uint64_t read_seed(JsonReader& reader, const JsonAt& at) {
  return static_cast<std::uint64_t>(whole(reader, at, 9007199254740991, "9007199254740991"));
}

Result<Done> read_line(std::string_view where, int line, std::string_view text, std::string_view format,
                       const std::function<void(JsonReader&, JsonFields&)>& read,
                       std::span<const std::string_view> left_out) {
  const auto json = parse_json_line(where, line, text, left_out);
  if (!json) return json.error();
  const auto name = std::string(where) + ":" + std::to_string(line);  // "tasks.jsonl:3"
  JsonReader reader(name);
  const JsonAt root{*json};  // the fields keep a reference to it
  JsonFields fields(reader, root);
  read_format(reader, fields, format);
  read(reader, fields);
  fields.finish();
  if (reader.error()) return *reader.error();
  return Done{};
}

}  // namespace unietp
