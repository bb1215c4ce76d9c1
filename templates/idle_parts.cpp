#include "templates/idle_parts.h"

#include <algorithm>
#include <set>

#include "core/text.h"
#include "templates/constraint_kinds.h"

namespace unietp {
namespace {

/// The expression without its layout, so that equal ones have equal texts.
std::string bare(const Sexpr& expression) {
  if (expression.is_atom()) return expression.text;
  if (!expression.is_list()) return "\"" + expression.text + "\"";
  std::string text = "(";
  for (const auto& child : expression.children) text += bare(child) + " ";
  return text + ")";
}

std::size_t uses_of(const std::string& variable, const Sexpr& expression) {
  if (expression.is_atom(variable)) return 1;
  std::size_t uses = 0;
  for (const auto& child : expression.children) uses += uses_of(variable, child);
  return uses;
}

class IdleParts {
 public:
  explicit IdleParts(const TemplateSource& source) : source_(source), value_(source.value) {}

  std::vector<Error> run() {
    check_text(source_.title, "title");
    for (const auto& parameter : value_.parameters) check_parameter(parameter);
    check_constraints();
    check_repeated(source_.init, "start constraint");
    for (const auto& start : source_.init) check_parts(start);
    for (const auto& goal : source_.goal) {
      check_parts(goal);
      if (source_.goal_read) check_variables(goal);  // else a misspelled variable would be told twice
    }
    check_repeated(source_.phrasings, "phrasing");
    for (const auto& phrasing : source_.phrasings) check_text(phrasing, "phrasing");
    return std::move(errors_);
  }

 private:
  void error(SourcePos pos, std::string message) {
    errors_.push_back({Error::Kind::Schema, value_.file, pos, std::move(message)});
  }

  void check_text(const Sexpr& text, const std::string& what) {
    if (text.kind != Sexpr::Kind::String) return;  // already told
    if (trim(text.text).empty()) error(text.pos, "this " + what + " is empty");
    const bool one_line = std::none_of(text.text.begin(), text.text.end(),
                                       [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
    if (!one_line) {
      error(text.pos, "a " + what + " must be on one line, without tabs; is a closing '\"' missing?");
    }
  }

  void check_parameter(const Parameter& parameter) {
    std::set<std::string> seen;
    for (const auto& word : parameter.affordances) {
      if (!seen.insert(word).second) {
        error(parameter.pos, "duplicate '" + word + "' for placeholder '" + parameter.name + "'");
      }
    }
    if (asks_for(parameter, ParameterWord::Any) && seen.size() > 1) {
      error(parameter.pos, "'any' must be the only word; write (" + parameter.name + " - any)");
    }
    if (asks_for(parameter, ParameterWord::Furniture) && asks_for(parameter, ParameterWord::Movable)) {
      error(parameter.pos, "no category is both 'furniture' and 'movable'");
    }
  }

  void check_constraints() {
    std::set<std::string> seen;
    for (const auto& constraint : value_.constraints) {
      if (!seen.insert(to_text(constraint)).second) {
        error(constraint.pos, "duplicate constraint");
      }
      std::set<std::string> arguments;
      for (const auto& argument : constraint.arguments) {
        if (argument.starts_with('0')) error(constraint.pos, "a number must not have leading zeros");
        if (!arguments.insert(argument).second) {
          error(constraint.pos, "duplicate '" + argument + "' in this constraint");
        }
      }
    }
  }

  void check_repeated(const std::vector<Sexpr>& items, const std::string& what) {
    std::set<std::string> seen;
    for (const auto& item : items) {
      if (!seen.insert(bare(item)).second) error(item.pos, "duplicate " + what);
    }
  }

  void check_parts(const Sexpr& expression) {
    if (expression.is_form("and") || expression.is_form("or")) {
      std::set<std::string> seen;
      for (std::size_t i = 1; i < expression.children.size(); ++i) {
        if (seen.insert(bare(expression.children[i])).second) continue;
        error(expression.children[i].pos, "duplicate part of '" + expression.children[0].text + "'");
      }
    }
    for (const auto& child : expression.children) check_parts(child);
  }

  void check_variables(const Sexpr& expression) {
    for (const auto& child : expression.children) {
      if (is_binder(child) && uses_of(child.children[0].text, expression) == 1) {
        error(child.pos, "the variable " + child.children[0].text + " is bound here but never used");
      }
      check_variables(child);
    }
  }

  const TemplateSource& source_;
  const Template& value_;
  std::vector<Error> errors_;
};

}  // namespace

std::vector<Error> idle_parts(const TemplateSource& source) { return IdleParts(source).run(); }

}  // namespace unietp
