#include "function_sizes.h"

#include <algorithm>
#include <regex>

#include "code_pieces.h"
#include "core/text.h"

namespace unietp {
namespace {

/// The code without comments, literals and preprocessor lines, each line where it was.
std::string bare(std::string_view code) {
  std::string kept;
  for (const CodePiece& piece : pieces_of(code)) {
    if (piece.kind == CodePiece::Kind::Code) {
      kept += piece.text;
    } else {
      kept.append(static_cast<std::size_t>(std::count(piece.text.begin(), piece.text.end(), '\n')), '\n');
    }
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
