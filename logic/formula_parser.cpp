#include "logic/formula_parser.h"

#include <array>

#include "core/text.h"
#include "logic/formula_words.h"

namespace unietp {
namespace {

std::string ordinal(std::size_t index) {
  constexpr std::array<std::string_view, 3> kNames = {"first", "second", "third"};
  return std::string(kNames.at(index));
}

std::string plural_of(FormulaParser::Sort sort) {
  switch (sort) {
    case FormulaParser::Sort::Object:
      return "objects";
    case FormulaParser::Sort::Room:
      return "rooms";
    case FormulaParser::Sort::Agent:
      return "the agent";
    case FormulaParser::Sort::Unknown:
      break;
  }
  return "anything";
}

std::string nearest_word(std::string_view word) {
  std::vector<std::string> names;
  for (const auto& known : kOperatorWords) names.emplace_back(known.word);
  for (const auto& known : all_predicates()) names.emplace_back(known.name);
  return nearest_name(word, names);
}

std::string unknown_word(std::string_view word, const std::string& near) {
  const std::string unknown = "unknown operator or predicate " + quoted(word);
  if (!near.empty()) return unknown + "; did you mean " + quoted(near) + "?";
  std::vector<std::string> operators;
  for (const auto& known : kOperatorWords) operators.emplace_back(known.word);
  return unknown + "; accepted are the operators " + join(operators, ", ") + " and the predicates of docs/logic.md";
}

const OperatorWord* operator_named(std::string_view word) {
  for (const auto& known : kOperatorWords) {
    if (known.word == word) return &known;
  }
  return nullptr;
}

}  // namespace

std::string quoted(std::string_view word) {
  std::string text = "'";
  text += word;
  text += '\'';
  return text;
}

std::string shown(const Sexpr& expression) {
  switch (expression.kind) {
    case Sexpr::Kind::Atom:
      return quoted(expression.text);
    case Sexpr::Kind::String:
      return "a string";
    case Sexpr::Kind::List:
      break;
  }
  if (expression.children.empty()) return "'()'";
  return expression.children.front().is_atom() ? "'(" + expression.children.front().text + " …)'" : "a list";
}

bool is_variable(const Sexpr& expression) {
  return expression.is_atom() && expression.text.size() > 1 && expression.text.front() == '?';
}

std::string example_of(const PredicateInfo& predicate) {
  std::string text = "(";
  text += predicate.name;
  text += " ?x";
  if (predicate.arguments.size() == 2) {
    switch (predicate.arguments[1]) {
      case ArgumentKind::Object:
        text += " ?y";
        break;
      case ArgumentKind::Room:
        text += " ?room";
        break;
      case ArgumentKind::Symbol:
        text += predicate.predicate == Predicate::Filled ? " water" : " word";
        break;
    }
  }
  return text + ")";
}

FormulaParser::FormulaParser(std::string_view where, const std::vector<std::string>& bound) : where_(where) {
  for (const auto& name : bound) scope_.push_back({name, Sort::Unknown});
}

std::nullopt_t FormulaParser::note(const Sexpr& at, std::string message) {
  errors_.push_back({Error::Kind::Parse, where_, at.pos, std::move(message)});
  return std::nullopt;
}

bool FormulaParser::has_parts(const Sexpr& expression, std::size_t count, std::string_view form) {
  const std::size_t found = expression.children.size() - 1;
  if (found == count) return true;
  note(expression, quoted(expression.children.front().text) + " takes " + std::to_string(count) +
                       (count == 1 ? " part" : " parts") + ", found " + std::to_string(found) + "; write " +
                       std::string(form));
  return false;
}

const FormulaParser::Variable* FormulaParser::find(std::string_view name) const {
  for (const auto& variable : scope_) {
    if (variable.name == name) return &variable;
  }
  return nullptr;
}

std::string FormulaParser::unbound(const std::string& name) const {
  std::vector<std::string> names;
  for (const auto& variable : scope_) names.push_back("?" + variable.name);
  std::string text = "the variable ?" + name + " is not bound here; ";
  if (names.empty()) return text + "bind it with forall, exists or count";
  const auto near = nearest_name("?" + name, names);
  return text + "bound are " + join(names, ", ") +
         (near.size() < 3 ? "" : "; did you mean " + quoted(near) + "?");  // of one letter any is near
}

std::optional<Formula> FormulaParser::formula(const Sexpr& expression, const Place& place) {
  if (!expression.is_list()) {
    return note(expression, "expected a formula in brackets such as (open ?x), found " + shown(expression));
  }
  if (expression.children.empty()) {
    return note(expression, "empty brackets; expected an operator or a predicate after '('");
  }
  const Sexpr& head = expression.children.front();
  if (!head.is_atom()) {
    return note(head, "expected the name of an operator or a predicate after '(', found " + shown(head));
  }
  if (const auto* known = operator_named(head.text)) return operation(known->op, expression, place);
  if (const auto predicate = predicate_named(head.text)) return predicate_atom(info(*predicate), expression, place);
  const auto near = nearest_word(head.text);
  note(head, unknown_word(head.text, near));
  // The parts of a misspelled operator are read, for what else is wrong with them.
  if (const auto* similar = operator_named(near)) operation(similar->op, expression, place);
  return std::nullopt;
}

std::optional<Formula> FormulaParser::operation(Formula::Op op, const Sexpr& expression, const Place& place) {
  using enum Formula::Op;
  const std::string word = expression.children.front().text;
  Place below = place;
  if (is_temporal(op) && !place.temporal) {
    note(expression, "the temporal operator " + quoted(word) + " is not allowed here; " +
                         (place.inside_where ? "a :where is evaluated only in the first state"
                                             : "this formula is evaluated in a single state"));
    below.temporal = true;  // said once
  }
  if (is_temporal(op)) below.predicates = true;
  switch (op) {
    case Equal:
      return equality(expression);
    case And:
    case Or:
      return with_parts(op, expression, below);
    case Not:
      return fixed_parts(op, 1, "(not f)", expression, below);
    case Imply:
      return fixed_parts(op, 2, "(imply f g)", expression, below);
    case Forall:
    case Exists:
    case Number:
      return quantifier(op, expression, below);
    case Count:
    case CountCompare:
      return count(expression, below);
    case AtEnd:
    case Sometime:
    case Always:
      return fixed_parts(op, 1, "(" + word + " f)", expression, below);
    case Until:
    case Before:
      return fixed_parts(op, 2, "(" + word + " f g)", expression, below);
    case Atom:
      break;
  }
  return note(expression, "expected a formula");
}

std::optional<Formula> FormulaParser::with_parts(Formula::Op op, const Sexpr& expression, const Place& place) {
  Formula result;
  result.op = op;
  bool sound = true;
  for (std::size_t i = 1; i < expression.children.size(); ++i) {
    if (auto part = formula(expression.children[i], place)) {
      result.children.push_back(std::move(*part));
    } else {
      sound = false;
    }
  }
  if (!sound) return std::nullopt;
  return result;
}

std::optional<Formula> FormulaParser::fixed_parts(Formula::Op op, std::size_t count, std::string_view form,
                                                  const Sexpr& expression, const Place& place) {
  const bool complete = has_parts(expression, count, form);
  auto read = with_parts(op, expression, place);
  if (!complete) return std::nullopt;
  return read;
}

std::optional<Formula> FormulaParser::equality(const Sexpr& expression) {
  if (!has_parts(expression, 2, "(= ?x ?y)")) return std::nullopt;
  Formula result;
  result.op = Formula::Op::Equal;
  for (std::size_t i = 1; i <= 2; ++i) {
    auto term = variable_term(expression.children[i], "the " + ordinal(i - 1) + " part of '='", "?x");
    if (term) result.terms.push_back(std::move(*term));
  }
  if (result.terms.size() != 2) return std::nullopt;
  return result;
}

std::optional<Formula> FormulaParser::predicate_atom(const PredicateInfo& predicate, const Sexpr& expression,
                                                     const Place& place) {
  if (!place.predicates) {
    note(expression, quoted(predicate.name) +
                         " is outside every temporal operator; in a goal, put it under at-end, sometime, "
                         "always, until or before");
  }
  if (expression.children.size() != predicate.arguments.size() + 1) {
    return note(expression, quoted(predicate.name) + " takes " + std::to_string(predicate.arguments.size()) +
                                (predicate.arguments.size() == 1 ? " argument" : " arguments") + ", found " +
                                std::to_string(expression.children.size() - 1) + "; write " + example_of(predicate));
  }
  Formula result;
  result.op = Formula::Op::Atom;
  result.predicate = predicate.predicate;
  for (std::size_t i = 0; i < predicate.arguments.size(); ++i) {
    if (auto term = argument(predicate, i, expression.children[i + 1])) result.terms.push_back(std::move(*term));
  }
  if (!place.predicates || result.terms.size() != predicate.arguments.size()) return std::nullopt;
  return result;
}

std::optional<Term> FormulaParser::argument(const PredicateInfo& predicate, std::size_t index,
                                            const Sexpr& expression) {
  const std::string name = "the " + ordinal(index) + " argument of " + quoted(predicate.name);
  const ArgumentKind kind = predicate.arguments[index];
  if (kind == ArgumentKind::Symbol) {
    if (!expression.is_atom() || expression.text.front() == '?') {
      return note(expression, name + " must be a word such as " +
                                  (predicate.predicate == Predicate::Color ? "red" : "water") + ", found " +
                                  shown(expression));
    }
    return Term{Term::Kind::Symbol, expression.text};
  }
  const bool agent_welcome = predicate.predicate == Predicate::InRoom && index == 0;
  if (expression.is_atom("agent")) {
    if (agent_welcome) return Term{Term::Kind::Agent, "agent"};
    return note(expression, name + " cannot be the agent; 'agent' is allowed only as the first argument of 'in_room'");
  }
  auto term = variable_term(expression, name, agent_welcome ? "?x, or 'agent'" : "?x");
  if (!term) return term;
  const Sort sort = find(term->name)->sort;
  const bool fits = sort == Sort::Unknown || (sort == Sort::Agent && agent_welcome) ||
                    (sort == Sort::Object && kind == ArgumentKind::Object) ||
                    (sort == Sort::Room && kind == ArgumentKind::Room);
  if (fits) return term;
  return note(expression, name + " must be " + (kind == ArgumentKind::Room ? "a room" : "an object") + "; ?" +
                              term->name + " ranges over " + plural_of(sort));
}

std::optional<Term> FormulaParser::variable_term(const Sexpr& expression, std::string_view place_name,
                                                 std::string_view example) {
  if (!is_variable(expression)) {
    std::string message = std::string(place_name) + " must be a variable such as " + std::string(example) + ", found " +
                          shown(expression);
    if (expression.is_atom() && find(expression.text) != nullptr)
      message += "; did you mean '?" + expression.text + "'?";
    return note(expression, std::move(message));
  }
  const std::string name = expression.text.substr(1);
  if (find(name) == nullptr) return note(expression, unbound(name));
  return Term{Term::Kind::Variable, name};
}

}  // namespace unietp
