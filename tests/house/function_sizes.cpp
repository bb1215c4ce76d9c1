#include "function_sizes.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "core/text.h"

namespace unietp {
namespace {

bool is_name_char(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The place behind a comment, a string or a character that begins at `at`; `at` where none does.
std::size_t behind_literal(std::string_view code, std::size_t at) {
  const auto behind = [&](std::string_view end, std::size_t from) {
    const auto found = code.find(end, from);
    return found == std::string_view::npos ? code.size() : found + end.size();
  };
  const bool after_name = at > 0 && is_name_char(code[at - 1]);
  const std::string_view rest = code.substr(at);
  if (rest.starts_with("//")) return std::min(code.find('\n', at), code.size());
  if (rest.starts_with("/*")) return behind("*/", at + 2);
  if (rest.starts_with("R\"") && !after_name) {
    const auto open = code.find('(', at);
    return behind(")" + std::string(code.substr(at + 2, open - at - 2)) + "\"", open);
  }
  if (rest.front() != '"' && (rest.front() != '\'' || after_name)) return at;
  std::size_t end = at + 1;
  while (end < code.size() && code[end] != code[at]) end += code[end] == '\\' ? 2 : 1;
  return std::min(end + 1, code.size());
}

/// The code without comments, literals and preprocessor lines, each line where it was.
std::string bare(std::string_view code) {
  std::string kept;
  for (std::size_t at = 0; at < code.size();) {
    const auto behind = behind_literal(code, at);
    if (behind == at) {
      kept += code[at++];
      continue;
    }
    kept.append(static_cast<std::size_t>(std::count(code.begin() + static_cast<std::ptrdiff_t>(at),
                                                    code.begin() + static_cast<std::ptrdiff_t>(behind), '\n')),
                '\n');
    at = behind;
  }
  std::string without_directives;
  bool goes_on = false;
  for (const auto& line : split(kept, '\n')) {
    const bool directive = goes_on || trim(line).starts_with('#');
    goes_on = directive && trim(line).ends_with('\\');
    if (!directive) without_directives += line;
    without_directives += '\n';
  }
  return without_directives;
}

enum class Block { Scope, Function, Other };

Block block_after(const std::string& text) {
  static const std::regex kScope(
      ".*\\bnamespace( [\\w:]+)?|extern|(template ?<.*> ?)?(class|struct|union|enum)\\b[^(=]*");
  if (std::regex_match(text, kScope)) return Block::Scope;
  return text.find('(') != std::string::npos && !text.ends_with('=') ? Block::Function : Block::Other;
}

}  // namespace

std::vector<SizedFunction> functions_of(std::string_view code) {
  std::vector<SizedFunction> functions;
  std::vector<Block> open;
  std::string text;  // since the last block or statement
  int line = 1;
  for (const char c : bare(code)) {
    if (c == '\n') ++line;
    const bool nested = std::any_of(open.begin(), open.end(), [](Block block) { return block != Block::Scope; });
    if (c == '{') {
      const std::string before(trim(text));
      open.push_back(nested ? Block::Other : block_after(before));
      if (open.back() == Block::Function) functions.push_back({line, 0, before});
      text.clear();
    } else if (c == '}') {
      if (!open.empty() && open.back() == Block::Function)
        functions.back().lines = std::max(0, line - functions.back().line - 1);
      if (!open.empty()) open.pop_back();
      text.clear();
    } else if (c == ';') {
      text.clear();
    } else {
      text += c == '\n' ? ' ' : c;
    }
  }
  return functions;
}

}  // namespace unietp
