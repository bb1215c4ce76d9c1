#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "scene/json_reader.h"

namespace unietp {

/// One line of a JSON-lines file; the position of a syntax error is that in the file. Errors: Parse.
Result<nlohmann::ordered_json> parse_json_line(std::string_view where, int line, std::string_view text);

/// Reads a line that is an object of this format: `read` takes its other fields, and none may be left over. Errors:
/// Parse, Schema.
Result<Done> read_line(std::string_view where, int line, std::string_view text, std::string_view format,
                       const std::function<void(JsonReader&, JsonFields&)>& read);

/// Fields of records; problems go to the reader.
void read_format(JsonReader& reader, JsonFields& fields, std::string_view expected);
int read_whole(JsonReader& reader, const JsonAt& at);           // 0 to 1e9
std::uint64_t read_seed(JsonReader& reader, const JsonAt& at);  // 0 to 2^53 - 1, which a double holds exactly
std::string text_or_empty(JsonReader& reader, const JsonAt& at);

}  // namespace unietp
