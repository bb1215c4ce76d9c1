#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace unietp {

/// One wording of an episode; `goal` is its own where it refers to one object, else "".
struct WordingRecord {
  std::string text, writer, style, goal;
  std::vector<std::string> checks;  // names of those that the text passed
  std::string fallback;             // why the grammar wrote where a model was asked; "" when it was not
};

/// A line of wordings.jsonl.
struct WordingsRecord {
  std::string task, pair;
  std::map<std::string, WordingRecord> wordings;  // "direct", and "referring" and "complex" where there are such
};
Result<WordingsRecord> read_wordings(std::string_view where, int line, std::string_view text);

}  // namespace unietp
