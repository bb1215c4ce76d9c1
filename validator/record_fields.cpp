#include "validator/record_fields.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "scene/json_parse.h"

namespace unietp {

using Json = nlohmann::ordered_json;

void read_format(JsonReader& reader, JsonFields& fields, std::string_view expected) {
  if (const auto f = fields.required("format")) {
    const auto format = reader.text(*f);
    if (format != expected)
      reader.fail(*f, "expected the format " + in_quotes(expected) + ", not " + in_quotes(format));
  }
}

Result<Json> parse_json_line(std::string_view where, int line, std::string_view text) {
  auto json = parse_json(where, text);
  if (json) return json;
  Error error = json.error();
  error.pos = {line, error.pos.column > 0 ? error.pos.column : 1};
  return error;
}

std::string text_or_empty(JsonReader& reader, const JsonAt& at) {
  const auto* text = at.json.get_ptr<const Json::string_t*>();
  return text != nullptr && text->empty() ? std::string() : reader.text(at);
}

int read_whole(JsonReader& reader, const JsonAt& at) {
  const double value = reader.number(at);
  if (reader.error()) return 0;
  const bool fits = value >= 0 && value <= 1e9 && value == std::floor(value);
  if (!fits) reader.fail(at, "expected a whole number from 0 to 1e9");
  return fits ? static_cast<int>(value) : 0;
}

Result<Done> read_line(std::string_view where, int line, std::string_view text, std::string_view format,
                       const std::function<void(JsonReader&, JsonFields&)>& read) {
  const auto json = parse_json_line(where, line, text);
  if (!json) return json.error();
  const auto name = std::string(where) + ":" + std::to_string(line);  // "tasks.jsonl:3"
  JsonReader reader(name);
  JsonFields fields(reader, JsonAt{*json});
  read_format(reader, fields, format);
  read(reader, fields);
  fields.finish();
  if (reader.error()) return *reader.error();
  return Done{};
}

}  // namespace unietp
