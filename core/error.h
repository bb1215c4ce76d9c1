#pragma once

#include <string>
#include <string_view>

namespace unietp {

/// 1-based; {0, 0} when the input has no text position. Columns count bytes.
struct SourcePos {
  int line = 0, column = 0;
  bool operator==(const SourcePos&) const = default;
};

/// An expected failure as a value: what is wrong, where, and what would be accepted.
struct Error {
  enum class Kind { Parse, Schema, Unsatisfiable, Io, Usage };
  Kind kind = Kind::Parse;
  std::string where;  // file name; for data a JSON pointer or table.column; may be empty
  SourcePos pos;
  std::string message;  // lower case, no full stop, says what is accepted
  bool operator==(const Error&) const = default;
};

/// "kitchen.json:3:7: parse error: expected ':'", on one line and safe for a terminal (core/in_quotes.h).
std::string format(const Error& error);

/// Line and column of byte `offset` of `text`; one past the end is allowed.
SourcePos locate(std::string_view text, std::size_t offset);

}  // namespace unietp
