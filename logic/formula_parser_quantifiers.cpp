#include <algorithm>
#include <charconv>

#include "logic/formula_parser.h"
#include "logic/formula_words.h"

namespace unietp {
namespace {

bool is_reserved(std::string_view word) { return word == "object" || word == "room" || word == "agent"; }

FormulaParser::Sort sort_of(const Domain& domain) {
  switch (domain.kind) {
    case Domain::Kind::Object:
      return FormulaParser::Sort::Object;
    case Domain::Kind::Room:
      return FormulaParser::Sort::Room;
    case Domain::Kind::Agent:
      return FormulaParser::Sort::Agent;
    case Domain::Kind::Categories:
      break;
  }
  const bool slices = std::any_of(domain.members.begin(), domain.members.end(), [](const auto& m) { return m.slice; });
  return slices ? FormulaParser::Sort::Object : FormulaParser::Sort::Unknown;
}

/// A number in its shortest form: "2", not "02".
std::optional<int> whole_number(const Sexpr& expression) {
  const std::string& text = expression.text;
  int value = -1;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (!expression.is_atom() || read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  if (value < 0 || std::to_string(value) != text) return std::nullopt;
  return value;
}

}  // namespace

std::optional<Formula> FormulaParser::with_binder(Formula::Op op, const Sexpr& binder, const Sexpr* body,
                                                  const Place& place) {
  const bool named = binder.is_list() && !binder.children.empty() && is_variable(binder.children[0]);
  const bool shaped = named && binder.children.size() == 3 && binder.children[1].is_atom("-");
  bool sound = shaped && body != nullptr;
  if (!shaped) note(binder, "expected a variable and its domain such as (?x - Mug), found " + shown(binder));
  if (!named) return std::nullopt;  // the body's variables would all seem unbound
  Formula result;
  result.op = op;
  result.variable = binder.children[0].text.substr(1);
  if (find(result.variable) != nullptr) {
    note(binder.children[0], "the variable ?" + result.variable + " is already bound here; choose another name");
    sound = false;
  }
  Variable bound{result.variable, Sort::Unknown};
  if (shaped) {
    if (auto read = domain(binder.children[2], result.variable, place)) {
      bound.sort = sort_of(*read);
      result.domain = std::move(*read);
    } else {
      sound = false;
    }
  }
  if (body == nullptr) return std::nullopt;
  scope_.push_back(std::move(bound));
  auto child = formula(*body, place);
  scope_.pop_back();
  if (!child || !sound) return std::nullopt;
  result.children.push_back(std::move(*child));
  return result;
}

std::optional<Formula> FormulaParser::quantifier(Formula::Op op, const Sexpr& expression, const Place& place) {
  const auto& parts = expression.children;
  if (op == Formula::Op::Number) {
    return note(expression,
                "'number' is allowed only inside a count: (count > (number (?x - A) f) (number (?y - B) g))");
  }
  const bool complete = has_parts(expression, 2, "(" + parts.front().text + " (?x - D) f)");
  if (parts.size() < 2) return std::nullopt;
  auto read = with_binder(op, parts[1], parts.size() > 2 ? &parts[2] : nullptr, place);
  if (!complete) return std::nullopt;
  return read;
}

std::optional<Formula> FormulaParser::number(const Sexpr& expression, const Place& place) {
  if (!expression.is_form("number")) {
    return note(expression, "expected (number (?y - D) g) to compare with, found " + shown(expression));
  }
  if (!has_parts(expression, 2, "(number (?x - D) f)")) return std::nullopt;
  return with_binder(Formula::Op::Number, expression.children[1], &expression.children[2], place);
}

std::optional<Formula> FormulaParser::count(const Sexpr& expression, const Place& place) {
  const auto& parts = expression.children;
  if (parts.size() != 4 && parts.size() != 5) {
    return note(expression, "'count' takes 3 or 4 parts, found " + std::to_string(parts.size() - 1) +
                                "; write (count >= 2 (?x - D) f) or "
                                "(count > (number (?x - D) f) (number (?y - E) g))");
  }
  const auto* known = std::find_if(kComparisons.begin(), kComparisons.end(),
                                   [&](const auto& word) { return parts[1].is_atom(symbol_of(word.comparison)); });
  const bool compares = known != kComparisons.end();
  if (!compares) {
    note(parts[1], "expected a comparison (=, >=, <=, > or <) after 'count', found " + shown(parts[1]));
  }
  const Comparison comparison = compares ? known->comparison : Comparison::Equal;
  if (!parts[2].is_list()) {
    auto read = count_with_number(comparison, expression, place);
    if (!compares) return std::nullopt;
    return read;
  }
  Formula result;
  result.op = Formula::Op::CountCompare;
  result.comparison = comparison;
  // The long shape is canonical; `(count > (?x - A) f (number …))` leaves the first `number` out.
  auto left =
      parts.size() == 4 ? number(parts[2], place) : with_binder(Formula::Op::Number, parts[2], &parts[3], place);
  auto right = number(parts.back(), place);
  if (!compares || !left || !right) return std::nullopt;
  result.children = {std::move(*left), std::move(*right)};
  return result;
}

std::optional<Formula> FormulaParser::count_with_number(Comparison comparison, const Sexpr& expression,
                                                        const Place& place) {
  const auto& parts = expression.children;
  const auto value = whole_number(parts[2]);
  if (!value) note(parts[2], "expected a whole number from 0 after the comparison, found " + shown(parts[2]));
  if (parts.size() != 5) {
    return note(expression, "'count' with a number takes 4 parts, found 3; write (count >= 2 (?x - D) f)");
  }
  auto result = with_binder(Formula::Op::Count, parts[3], &parts[4], place);
  if (!result || !value) return std::nullopt;
  result->comparison = comparison;
  result->number = *value;
  return result;
}

std::optional<Domain> FormulaParser::domain(const Sexpr& expression, const std::string& variable, const Place& place) {
  if (expression.is_list() && expression.children.size() > 1 && expression.children[1].is_atom(":where")) {
    return domain_with_where(expression, variable, place);
  }
  if (expression.is_form("either")) return either(expression);
  Domain result;
  if (expression.is_atom("object")) result.kind = Domain::Kind::Object;
  if (expression.is_atom("room")) result.kind = Domain::Kind::Room;
  if (expression.is_atom("agent")) result.kind = Domain::Kind::Agent;
  if (result.kind != Domain::Kind::Categories) return result;
  if (!expression.is_atom()) {
    return note(expression,
                "expected a domain: a category, A/slice, object, room, agent, (either A B) or (A :where f), found " +
                    shown(expression));
  }
  auto member = category(expression);
  if (!member) return std::nullopt;
  result.members.push_back(std::move(*member));
  return result;
}

std::optional<Domain> FormulaParser::either(const Sexpr& expression) {
  if (expression.children.size() < 2) return note(expression, "'either' takes at least one category");
  Domain result;
  bool sound = true;
  for (std::size_t i = 1; i < expression.children.size(); ++i) {
    auto member = category(expression.children[i]);
    if (!member) {
      sound = false;
    } else if (std::find(result.members.begin(), result.members.end(), *member) != result.members.end()) {
      note(expression.children[i], quoted(expression.children[i].text) + " occurs twice in this 'either'");
      sound = false;
    } else {
      result.members.push_back(std::move(*member));
    }
  }
  if (!sound) return std::nullopt;
  return result;
}

std::optional<Domain> FormulaParser::domain_with_where(const Sexpr& expression, const std::string& variable,
                                                       const Place& place) {
  const Sexpr& mark = expression.children[1];
  if (!place.where)
    return note(mark, "a :where is not allowed here; a formula that is evaluated in a single state has none");
  if (expression.children.size() != 3) {
    return note(mark, "':where' takes one formula, found " + std::to_string(expression.children.size() - 2) +
                          "; write (A :where f)");
  }
  Place no_where = place;
  no_where.where = false;
  auto result = domain(expression.children[0], variable, no_where);
  scope_.push_back({variable, result ? sort_of(*result) : Sort::Unknown});
  auto condition = formula(expression.children[2], {true, false, false, true});
  scope_.pop_back();
  if (!result || !condition) return std::nullopt;
  result->where.push_back(std::move(*condition));
  return result;
}

std::optional<Domain::Member> FormulaParser::category(const Sexpr& expression) {
  if (!expression.is_atom() || std::string_view("?:-").find(expression.text.front()) != std::string_view::npos) {
    return note(expression, "expected a category, found " + shown(expression));
  }
  if (is_reserved(expression.text)) {
    return note(expression, quoted(expression.text) + " is not allowed in 'either'; expected a category");
  }
  const auto slash = expression.text.find('/');
  if (slash == std::string::npos) return Domain::Member{expression.text, false};
  if (slash == 0 || expression.text.substr(slash) != "/slice") {
    return note(expression, "expected a category or a category with /slice, found " + shown(expression));
  }
  return Domain::Member{expression.text.substr(0, slash), true};
}

}  // namespace unietp
