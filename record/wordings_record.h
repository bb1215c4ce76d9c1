#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace unietp {

/// One wording of an episode. `goal`: its own if it refers to one object or asks for something else, else "".
struct WordingRecord {
  std::string text, writer, style, goal;
  std::vector<std::string> checks;  // names of the checks that the text passed
  std::string fallback;             // why the grammar wrote the text instead of a model; "" otherwise
  bool operator==(const WordingRecord&) const = default;
};

/// What the wordings of an episode with a name of its own are. By name, as they are looked at in this order.
enum class WordingKind : std::uint8_t { Complex, Contrast, Direct, Referring };
std::string_view name_of(WordingKind kind);  // "direct"

/// The style of direct wordings, and of most instructions (docs/instructions.md).
inline constexpr std::string_view kDirectStyle = "direct";

/// A line of wordings.jsonl.
struct WordingsRecord {
  std::string task, pair;
  std::map<WordingKind, WordingRecord> wordings;  // Direct, and the other kinds if they exist
  std::vector<WordingRecord> others;              // further ones of the task's goal
  bool operator==(const WordingsRecord&) const = default;
};
/// Errors: Parse with line and column; Schema with line and JSON pointer.
Result<WordingsRecord> read_wordings(std::string_view where, int line, std::string_view text);

}  // namespace unietp
