#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "scene/json_reader.h"
#include "scene/trace.h"

namespace unietp {

/// One line of a JSON-lines file, without the fields of the names in `left_out`; the position of a syntax error is that
/// in the file. Errors: Parse.
Result<nlohmann::ordered_json> parse_json_line(std::string_view where, int line, std::string_view text,
                                               std::span<const std::string_view> left_out = {});

/// Reads a line that is an object of this format: `read` takes the other fields but those of the names in `left_out`,
/// and unknown fields are errors. Errors: Parse, Schema.
Result<Done> read_line(std::string_view where, int line, std::string_view text, std::string_view format,
                       const std::function<void(JsonReader&, JsonFields&)>& read,
                       std::span<const std::string_view> left_out = {});

/// Read fields of records. Errors go to the reader.
void read_format(JsonReader& reader, JsonFields& fields, std::string_view expected);
int read_whole(JsonReader& reader, const JsonAt& at);           // 0 to 1e9
std::uint64_t read_seed(JsonReader& reader, const JsonAt& at);  // 0 to 2^53 - 1, which a double holds exactly
/// Any text, also an empty one.
std::string text_or_empty(JsonReader& reader, const JsonAt& at);

/// Changes from moment to moment, at least two.
std::vector<Delta> read_moments(JsonReader& reader, const JsonAt& at);

/// Reads a value with one of the readers of scene/; the JSON pointer of an error is completed.
template <class T>
T read_part(JsonReader& reader, const JsonAt& at, Result<T> (*read)(std::string_view, const nlohmann::ordered_json&),
            const nlohmann::ordered_json& json) {
  auto value = read("", json);
  if (value) return std::move(*value);
  const auto& inner = value.error().where;
  reader.fail(at.pointer() + (inner.empty() || inner[0] != '#' ? "" : inner.substr(1)), value.error().message);
  return {};
}

}  // namespace unietp
