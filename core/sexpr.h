#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace unietp {

/// One S-expression: an atom (`open`, `?x`, `3`, `"a string"`) or a list; remembers where it stood.
struct Sexpr {
  enum class Kind { Atom, String, List };
  Kind kind = Kind::Atom;
  std::string text;             // of an atom or a string (without quotes, escapes resolved)
  std::vector<Sexpr> children;  // of a list
  SourcePos pos;                // of the first byte
  SourcePos end;                // of the last byte (a list's closing bracket)

  bool is_list() const { return kind == Kind::List; }  // what it is
  bool is_atom() const { return kind == Kind::Atom; }
  bool is_atom(std::string_view word) const { return is_atom() && text == word; }
  /// A list whose first child is the atom `word`.
  bool is_form(std::string_view word) const { return is_list() && !children.empty() && children.front().is_atom(word); }
};

/// All top-level expressions of a text. `;` starts a comment that ends with the line; strings know \" and \\ and \n.
/// `start` is the position of the text's first byte, for text cut out of a larger file.
/// Errors: Parse with line and column: a missing or extra bracket, an unfinished string; nesting over
/// limits::kFormulaDepth, and more than limits::kExpressions.
Result<std::vector<Sexpr>> read_sexprs(std::string_view where, std::string_view text, SourcePos start = {1, 1});

/// Exactly one expression. Errors: as read_sexprs, and when there is none or more than one.
Result<Sexpr> read_sexpr(std::string_view where, std::string_view text, SourcePos start = {1, 1});

}  // namespace unietp
