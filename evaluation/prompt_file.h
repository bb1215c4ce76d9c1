#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace unietp {

/// A text with slots, in pieces. A line that has slots and nothing else, all of which are empty, is left out.
struct PromptPiece {
  std::string text;  // as it is
  std::string slot;  // the name of a slot that follows it; "" at the end of a line
  bool operator==(const PromptPiece&) const = default;
};
using PromptLine = std::vector<PromptPiece>;

/// How a model is told of an episode: `[system]`, what it is told once, and `[turn]`, what it is told at each step.
/// Lines before the first of the two that start with `#` are comments.
struct PromptFile {
  std::string name;    // of the file, without its ending
  std::string digest;  // SHA-256 of its bytes
  std::vector<PromptLine> system, turn;
};

/// Errors: Parse with line and column, for another form and for slots that are not among `slots`, which it lists.
Result<PromptFile> read_prompt(std::string_view where, std::string_view text, const std::vector<std::string>& slots);

}  // namespace unietp
