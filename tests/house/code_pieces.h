#pragma once

#include <string_view>
#include <vector>

namespace unietp {

/// A stretch of C++ code: a comment, a string or character with its quotes, or what stands between these.
struct CodePiece {
  enum class Kind { Code, Comment, Literal };
  Kind kind = Kind::Code;
  std::string_view text;  // of the code that was read, which must outlive it
};

/// All of the code, in order.
std::vector<CodePiece> pieces_of(std::string_view code);

}  // namespace unietp
