#include "core/sexpr.h"

#include <optional>

#include "core/limits.h"

namespace unietp {
namespace {

class Reader {
 public:
  Reader(std::string_view where, std::string_view text, SourcePos start) : where_(where), text_(text), pos_(start) {}

  Result<std::vector<Sexpr>> read_all() {
    std::vector<Sexpr> expressions;
    for (skip_space(); !done(); skip_space()) {
      auto expression = read(0);
      if (!expression) return expression.error();
      expressions.push_back(std::move(*expression));
    }
    return expressions;
  }

  Error error_at(SourcePos pos, std::string message) const {
    return {Error::Kind::Parse, where_, pos, std::move(message)};
  }

 private:
  bool done() const { return at_ >= text_.size(); }
  char peek() const { return text_[at_]; }

  char take() {
    const char c = text_[at_++];
    last_ = pos_;
    if (c == '\n') {
      ++pos_.line;
      pos_.column = 1;
    } else {
      ++pos_.column;
    }
    return c;
  }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  void skip_space() {
    while (!done() && (is_space(peek()) || peek() == ';')) {
      if (peek() == ';') {
        while (!done() && peek() != '\n') take();
      } else {
        take();
      }
    }
  }

  Result<Sexpr> read(int depth) {
    if (depth > limits::kFormulaDepth)
      return error_at(pos_, "brackets are nested deeper than " + std::to_string(limits::kFormulaDepth));
    if (++expressions_ > limits::kExpressions)
      return error_at(pos_, "more than " + std::to_string(limits::kExpressions) + " lists and words");
    if (peek() == ')') return error_at(pos_, "unexpected ')' without '('");
    if (peek() == '(') return read_list(depth);
    if (peek() == '"') return read_string();
    return read_atom();
  }

  Result<Sexpr> read_list(int depth) {
    Sexpr list{Sexpr::Kind::List, "", {}, pos_, pos_};
    take();
    for (skip_space(); !done() && peek() != ')'; skip_space()) {
      auto child = read(depth + 1);
      if (!child) return child.error();
      list.children.push_back(std::move(*child));
    }
    if (done()) {
      return error_at(pos_, "missing ')' for the '(' at line " + std::to_string(list.pos.line) + ", column " +
                                std::to_string(list.pos.column));
    }
    take();
    list.end = last_;
    return list;
  }

  Result<Sexpr> read_string() {
    Sexpr string{Sexpr::Kind::String, "", {}, pos_, pos_};
    take();
    while (!done() && peek() != '"') {
      char c = take();
      if (c == '\\' && !done()) {
        const SourcePos escape = last_;
        c = take();
        if (c == 'n')
          c = '\n';
        else if (c != '"' && c != '\\')
          return error_at(escape, R"(unknown escape; accepted are \", \\ and \n)");
      }
      string.text += c;
    }
    if (done()) return error_at(string.pos, "this string has no closing '\"'");
    take();
    string.end = last_;
    return string;
  }

  Result<Sexpr> read_atom() {
    Sexpr atom{Sexpr::Kind::Atom, "", {}, pos_, pos_};
    while (!done() && !is_space(peek()) && peek() != '(' && peek() != ')' && peek() != ';' && peek() != '"') {
      atom.text += take();
    }
    atom.end = last_;
    return atom;
  }

  std::string where_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t expressions_ = 0;  // read so far
  SourcePos pos_;
  SourcePos last_;
};

}  // namespace

Result<std::vector<Sexpr>> read_sexprs(std::string_view where, std::string_view text, SourcePos start) {
  return Reader(where, text, start).read_all();
}

Result<Sexpr> read_sexpr(std::string_view where, std::string_view text, SourcePos start) {
  Reader reader(where, text, start);
  auto all = reader.read_all();
  if (!all) return all.error();
  if (all->empty()) return reader.error_at(start, "expected an expression, found nothing");
  if (all->size() > 1) return reader.error_at((*all)[1].pos, "expected one expression, found a second");
  return std::move(all->front());
}

}  // namespace unietp
