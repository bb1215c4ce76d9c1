#include "core/error.h"

#include <algorithm>

#include "core/in_quotes.h"

namespace unietp {
namespace {

std::string_view name_of(Error::Kind kind) {
  switch (kind) {
    case Error::Kind::Parse:
      return "parse error";
    case Error::Kind::Schema:
      return "schema error";
    case Error::Kind::Unsatisfiable:
      return "unsatisfiable";
    case Error::Kind::Io:
      return "file error";
    case Error::Kind::Usage:
      return "usage error";
  }
  return "error";
}

}  // namespace

std::string format(const Error& error) {
  std::string text = error.where;
  if (error.pos.line > 0) {
    if (!text.empty()) text += ':';
    text += std::to_string(error.pos.line) + ':' + std::to_string(error.pos.column);
  }
  if (!text.empty()) text += ": ";
  return for_terminal(text + std::string(name_of(error.kind)) + ": " + error.message);
}

SourcePos locate(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
  const auto last_newline = before.rfind('\n');
  const std::size_t line_start = last_newline == std::string_view::npos ? 0 : last_newline + 1;
  return {line, static_cast<int>(before.size() - line_start) + 1};
}

}  // namespace unietp
