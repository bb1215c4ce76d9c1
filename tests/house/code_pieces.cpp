#include "code_pieces.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace unietp {
namespace {

bool is_name_char(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The comment or literal that begins at `at`; empty where none does.
CodePiece piece_at(std::string_view code, std::size_t at) {
  const auto up_to = [&](CodePiece::Kind kind, std::string_view end, std::size_t from) {
    const auto found = code.find(end, from);
    return CodePiece{kind, code.substr(at, found == std::string_view::npos ? found : found + end.size() - at)};
  };
  const bool after_name = at > 0 && is_name_char(code[at - 1]);
  const std::string_view rest = code.substr(at);
  if (rest.starts_with("//")) return {CodePiece::Kind::Comment, rest.substr(0, rest.find('\n'))};
  if (rest.starts_with("/*")) return up_to(CodePiece::Kind::Comment, "*/", at + 2);
  if (rest.starts_with("R\"") && !after_name) {
    const auto open = code.find('(', at);
    return up_to(CodePiece::Kind::Literal, ")" + std::string(code.substr(at + 2, open - at - 2)) + "\"", open);
  }
  if (rest.front() != '"' && (rest.front() != '\'' || after_name)) return {};
  std::size_t end = 1;
  while (end < rest.size() && rest[end] != rest.front()) end += rest[end] == '\\' ? 2 : 1;
  return {CodePiece::Kind::Literal, rest.substr(0, end + 1)};
}

}  // namespace

std::vector<CodePiece> pieces_of(std::string_view code) {
  std::vector<CodePiece> pieces;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < code.size();) {
    const CodePiece piece = piece_at(code, at);
    if (piece.text.empty()) {
      ++at;
      continue;
    }
    if (begin < at) pieces.push_back({CodePiece::Kind::Code, code.substr(begin, at - begin)});
    pieces.push_back(piece);
    begin = at += piece.text.size();
  }
  if (begin < code.size()) pieces.push_back({CodePiece::Kind::Code, code.substr(begin)});
  return pieces;
}

}  // namespace unietp
