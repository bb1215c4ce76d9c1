#include <algorithm>
#include <charconv>
#include <optional>

#include "core/text.h"
#include "logic/formula.h"
#include "logic/formula_words.h"

namespace unietp {
namespace {

/// What a variable may stand for, as far as its domain says; a category may be of objects or of rooms.
enum class Sort { Unknown, Object, Room, Agent };

struct Variable {
  std::string name;
  Sort sort = Sort::Unknown;
};

/// Where in a formula the reader stands: decides whether predicates and temporal operators are welcome.
struct Place {
  bool predicates = true;
  bool temporal = true;
  bool where = true;          // a `:where` may be written here
  bool inside_where = false;  // for the words of a message
};

std::string quoted(std::string_view word) {
  std::string text = "'";
  text += word;
  text += '\'';
  return text;
}

/// The source in short, for a message.
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

std::string ordinal(std::size_t index) {
  constexpr std::array<std::string_view, 3> kNames = {"first", "second", "third"};
  return std::string(kNames.at(index));
}

bool is_reserved(std::string_view word) { return word == "object" || word == "room" || word == "agent"; }

std::string article_of(Sort sort) {
  switch (sort) {
    case Sort::Object:
      return "objects";
    case Sort::Room:
      return "rooms";
    case Sort::Agent:
      return "the agent";
    case Sort::Unknown:
      break;
  }
  return "anything";
}

class Parser {
 public:
  Parser(std::string_view where, const std::vector<std::string>& bound) : where_(where) {
    for (const auto& name : bound) scope_.push_back({name, Sort::Unknown});
  }

  Result<Formula> formula(const Sexpr& expression, const Place& place) {
    if (!expression.is_list()) {
      return error(expression, "expected a formula in brackets such as (open ?x), found " + shown(expression));
    }
    if (expression.children.empty()) {
      return error(expression, "empty brackets; expected an operator or a predicate after '('");
    }
    const Sexpr& head = expression.children.front();
    if (!head.is_atom()) {
      return error(head, "expected the name of an operator or a predicate after '(', found " + shown(head));
    }
    for (const auto& known : kOperatorWords) {
      if (known.word == head.text) return operation(known.op, expression, place);
    }
    if (const auto predicate = predicate_named(head.text)) return predicate_atom(info(*predicate), expression, place);
    return error(head, unknown_word(head.text));
  }

 private:
  Error error(const Sexpr& at, std::string message) const {
    return {Error::Kind::Parse, where_, at.pos, std::move(message)};
  }

  static std::string unknown_word(std::string_view word) {
    std::vector<std::string> operators, names;
    for (const auto& known : kOperatorWords) operators.emplace_back(known.word);
    names = operators;
    for (const auto& known : all_predicates()) names.emplace_back(known.name);
    const std::string near = nearest_name(word, names);
    const std::string unknown = "unknown operator or predicate " + quoted(word);
    if (!near.empty()) return unknown + "; did you mean " + quoted(near) + "?";
    return unknown + "; accepted are the operators " + join(operators, ", ") + " and the predicates of docs/logic.md";
  }

  std::optional<Error> expect_parts(const Sexpr& expression, std::size_t count, std::string_view form) const {
    const std::size_t found = expression.children.size() - 1;
    if (found == count) return std::nullopt;
    return error(expression, quoted(expression.children.front().text) + " takes " + std::to_string(count) +
                                 (count == 1 ? " part" : " parts") + ", found " + std::to_string(found) + "; write " +
                                 std::string(form));
  }

  Result<Formula> operation(Formula::Op op, const Sexpr& expression, const Place& place) {
    using enum Formula::Op;
    if (is_temporal(op) && !place.temporal) {
      return error(
          expression,
          "the temporal operator " + quoted(expression.children.front().text) + " cannot stand here; " +
              (place.inside_where ? "a :where is read in the first state only" : "this formula is read in one state"));
    }
    Place below = place;
    if (is_temporal(op)) below.predicates = true;
    switch (op) {
      case Equal:
        return equality(expression);
      case And:
      case Or:
        return with_parts(op, expression, below);
      case Not:
        if (auto bad = expect_parts(expression, 1, "(not f)")) return *bad;
        return with_parts(op, expression, below);
      case Imply:
        if (auto bad = expect_parts(expression, 2, "(imply f g)")) return *bad;
        return with_parts(op, expression, below);
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
        if (auto bad = expect_parts(expression, 1, "(" + expression.children.front().text + " f)")) return *bad;
        return with_parts(op, expression, below);
      case Until:
      case Before:
        if (auto bad = expect_parts(expression, 2, "(" + expression.children.front().text + " f g)")) return *bad;
        return with_parts(op, expression, below);
      case Atom:
        break;
    }
    return error(expression, "expected a formula");
  }

  Result<Formula> with_parts(Formula::Op op, const Sexpr& expression, const Place& place) {
    Formula result;
    result.op = op;
    for (std::size_t i = 1; i < expression.children.size(); ++i) {
      auto part = formula(expression.children[i], place);
      if (!part) return part.error();
      result.children.push_back(std::move(*part));
    }
    return result;
  }

  Result<Term> variable_term(const Sexpr& expression, std::string_view place_name, std::string_view example) {
    if (!is_variable(expression)) {
      std::string message = std::string(place_name) + " must be a variable such as " + std::string(example) +
                            ", found " + shown(expression);
      if (expression.is_atom() && find(expression.text) != nullptr)
        message += "; did you mean '?" + expression.text + "'?";
      return error(expression, std::move(message));
    }
    const std::string name = expression.text.substr(1);
    if (find(name) == nullptr) return error(expression, unbound(name));
    return Term{Term::Kind::Variable, name};
  }

  std::string unbound(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& variable : scope_) names.push_back("?" + variable.name);
    std::string text = "the variable ?" + name + " is not bound here; ";
    if (names.empty()) return text + "bind it with forall, exists or count";
    return text + "bound are " + join(names, ", ");
  }

  const Variable* find(std::string_view name) const {
    for (const auto& variable : scope_) {
      if (variable.name == name) return &variable;
    }
    return nullptr;
  }

  Result<Formula> equality(const Sexpr& expression) {
    if (auto bad = expect_parts(expression, 2, "(= ?x ?y)")) return *bad;
    Formula result;
    result.op = Formula::Op::Equal;
    for (std::size_t i = 1; i <= 2; ++i) {
      auto term = variable_term(expression.children[i], "the " + ordinal(i - 1) + " part of '='", "?x");
      if (!term) return term.error();
      result.terms.push_back(std::move(*term));
    }
    return result;
  }

  Result<Formula> predicate_atom(const PredicateInfo& predicate, const Sexpr& expression, const Place& place) {
    if (!place.predicates) {
      return error(expression,
                   quoted(predicate.name) +
                       " stands outside every temporal operator; in a goal write it under at-end, sometime, "
                       "always, until or before");
    }
    if (expression.children.size() != predicate.arguments.size() + 1) {
      return error(expression, quoted(predicate.name) + " takes " + std::to_string(predicate.arguments.size()) +
                                   (predicate.arguments.size() == 1 ? " argument" : " arguments") + ", found " +
                                   std::to_string(expression.children.size() - 1) + "; write " + example_of(predicate));
    }
    Formula result;
    result.op = Formula::Op::Atom;
    result.predicate = predicate.predicate;
    for (std::size_t i = 0; i < predicate.arguments.size(); ++i) {
      auto term = argument(predicate, i, expression.children[i + 1]);
      if (!term) return term.error();
      result.terms.push_back(std::move(*term));
    }
    return result;
  }

  static std::string example_of(const PredicateInfo& predicate) {
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

  Result<Term> argument(const PredicateInfo& predicate, std::size_t index, const Sexpr& expression) {
    const std::string name = "the " + ordinal(index) + " argument of " + quoted(predicate.name);
    const ArgumentKind kind = predicate.arguments[index];
    if (kind == ArgumentKind::Symbol) {
      if (!expression.is_atom() || expression.text.front() == '?') {
        return error(expression, name + " must be a word such as " +
                                     (predicate.predicate == Predicate::Colour ? "red" : "water") + ", found " +
                                     shown(expression));
      }
      return Term{Term::Kind::Symbol, expression.text};
    }
    const bool agent_welcome = predicate.predicate == Predicate::InRoom && index == 0;
    if (expression.is_atom("agent")) {
      if (agent_welcome) return Term{Term::Kind::Agent, "agent"};
      return error(expression, name + " cannot be the agent; 'agent' stands only first in 'in_room'");
    }
    auto term = variable_term(expression, name, agent_welcome ? "?x, or 'agent'" : "?x");
    if (!term) return term;
    const Sort sort = find(term->name)->sort;
    const bool fits = sort == Sort::Unknown || (sort == Sort::Agent && agent_welcome) ||
                      (sort == Sort::Object && kind == ArgumentKind::Object) ||
                      (sort == Sort::Room && kind == ArgumentKind::Room);
    if (fits) return term;
    return error(expression, name + " must be " + (kind == ArgumentKind::Room ? "a room" : "an object") + "; ?" +
                                 term->name + " ranges over " + article_of(sort));
  }

  /// `(?x - D)` is read, then `body` with ?x in scope.
  template <class Body>
  Result<Formula> with_binder(Formula::Op op, const Sexpr& binder, const Place& place, Body body) {
    const bool shaped = binder.is_list() && binder.children.size() == 3 && is_variable(binder.children[0]) &&
                        binder.children[1].is_atom("-");
    if (!shaped) return error(binder, "expected a variable and its domain such as (?x - Mug), found " + shown(binder));
    Formula result;
    result.op = op;
    result.variable = binder.children[0].text.substr(1);
    if (find(result.variable) != nullptr) {
      return error(binder.children[0],
                   "the variable ?" + result.variable + " is already bound here; choose another name");
    }
    auto domain = this->domain(binder.children[2], result.variable, place);
    if (!domain) return domain.error();
    result.domain = std::move(*domain);
    scope_.push_back({result.variable, sort_of(result.domain)});
    auto child = body();
    scope_.pop_back();
    if (!child) return child.error();
    result.children.push_back(std::move(*child));
    return result;
  }

  static Sort sort_of(const Domain& domain) {
    switch (domain.kind) {
      case Domain::Kind::Object:
        return Sort::Object;
      case Domain::Kind::Room:
        return Sort::Room;
      case Domain::Kind::Agent:
        return Sort::Agent;
      case Domain::Kind::Categories:
        break;
    }
    const bool slices =
        std::any_of(domain.members.begin(), domain.members.end(), [](const auto& m) { return m.slice; });
    return slices ? Sort::Object : Sort::Unknown;
  }

  Result<Formula> quantifier(Formula::Op op, const Sexpr& expression, const Place& place) {
    const std::string word = expression.children.front().text;
    if (op == Formula::Op::Number) {
      return error(expression,
                   "'number' stands only inside a count: (count > (number (?x - A) f) (number (?y - B) g))");
    }
    if (auto bad = expect_parts(expression, 2, "(" + word + " (?x - D) f)")) return *bad;
    return with_binder(op, expression.children[1], place, [&] { return formula(expression.children[2], place); });
  }

  Result<Formula> number(const Sexpr& expression, const Place& place) {
    if (!expression.is_form("number")) {
      return error(expression, "expected (number (?y - D) g) to compare with, found " + shown(expression));
    }
    if (auto bad = expect_parts(expression, 2, "(number (?x - D) f)")) return *bad;
    return with_binder(Formula::Op::Number, expression.children[1], place,
                       [&] { return formula(expression.children[2], place); });
  }

  Result<Formula> count(const Sexpr& expression, const Place& place) {
    const auto& parts = expression.children;
    constexpr std::string_view kForms =
        "write (count >= 2 (?x - D) f) or (count > (number (?x - D) f) (number (?y - E) g))";
    if (parts.size() != 4 && parts.size() != 5) {
      return error(expression, "'count' takes 3 or 4 parts, found " + std::to_string(parts.size() - 1) + "; " +
                                   std::string(kForms));
    }
    const auto comparison = std::find_if(kComparisons.begin(), kComparisons.end(),
                                         [&](Comparison c) { return parts[1].is_atom(symbol_of(c)); });
    if (comparison == kComparisons.end()) {
      return error(parts[1], "expected a comparison (=, >=, <=, > or <) after 'count', found " + shown(parts[1]));
    }
    if (!parts[2].is_list()) return count_with_number(*comparison, expression, place);
    Formula result;
    result.op = Formula::Op::CountCompare;
    result.comparison = *comparison;
    // The long shape is canonical; `(count > (?x - A) f (number …))` leaves the first `number` out.
    auto left = parts.size() == 4
                    ? number(parts[2], place)
                    : with_binder(Formula::Op::Number, parts[2], place, [&] { return formula(parts[3], place); });
    if (!left) return left;
    auto right = number(parts.back(), place);
    if (!right) return right;
    result.children = {std::move(*left), std::move(*right)};
    return result;
  }

  Result<Formula> count_with_number(Comparison comparison, const Sexpr& expression, const Place& place) {
    const auto& parts = expression.children;
    const std::string& text = parts[2].text;
    int value = -1;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (!parts[2].is_atom() || read.ec != std::errc() || read.ptr != text.data() + text.size() || value < 0) {
      return error(parts[2], "expected a whole number from 0 after the comparison, found " + shown(parts[2]));
    }
    if (parts.size() != 5) {
      return error(expression, "'count' with a number takes 4 parts, found 3; write (count >= 2 (?x - D) f)");
    }
    auto result = with_binder(Formula::Op::Count, parts[3], place, [&] { return formula(parts[4], place); });
    if (!result) return result;
    result->comparison = comparison;
    result->number = value;
    return result;
  }

  Result<Domain> domain(const Sexpr& expression, const std::string& variable, const Place& place) {
    if (expression.is_list() && expression.children.size() > 1 && expression.children[1].is_atom(":where")) {
      return domain_with_where(expression, variable, place);
    }
    Domain result;
    if (expression.is_form("either")) {
      if (expression.children.size() < 2) return error(expression, "'either' takes at least one category");
      for (std::size_t i = 1; i < expression.children.size(); ++i) {
        auto member = category(expression.children[i]);
        if (!member) return member.error();
        result.members.push_back(std::move(*member));
      }
      return result;
    }
    if (expression.is_atom("object")) result.kind = Domain::Kind::Object;
    if (expression.is_atom("room")) result.kind = Domain::Kind::Room;
    if (expression.is_atom("agent")) result.kind = Domain::Kind::Agent;
    if (result.kind != Domain::Kind::Categories) return result;
    if (!expression.is_atom()) {
      return error(expression,
                   "expected a domain: a category, A/slice, object, room, agent, (either A B) or (A :where f), found " +
                       shown(expression));
    }
    auto member = category(expression);
    if (!member) return member.error();
    result.members.push_back(std::move(*member));
    return result;
  }

  Result<Domain> domain_with_where(const Sexpr& expression, const std::string& variable, const Place& place) {
    const Sexpr& mark = expression.children[1];
    if (!place.where) return error(mark, "a :where cannot stand here; a formula that is read in one state has none");
    if (expression.children.size() != 3) {
      return error(mark, "':where' takes one formula, found " + std::to_string(expression.children.size() - 2) +
                             "; write (A :where f)");
    }
    Place no_where = place;
    no_where.where = false;
    auto result = domain(expression.children[0], variable, no_where);
    if (!result) return result;
    scope_.push_back({variable, sort_of(*result)});
    auto condition = formula(expression.children[2], Place{true, false, false, true});
    scope_.pop_back();
    if (!condition) return condition.error();
    result->where.push_back(std::move(*condition));
    return result;
  }

  Result<Domain::Member> category(const Sexpr& expression) {
    if (!expression.is_atom() || std::string_view("?:-").find(expression.text.front()) != std::string_view::npos) {
      return error(expression, "expected a category, found " + shown(expression));
    }
    if (is_reserved(expression.text)) {
      return error(expression, quoted(expression.text) + " cannot stand in 'either'; it takes categories");
    }
    const auto slash = expression.text.find('/');
    if (slash == std::string::npos) return Domain::Member{expression.text, false};
    if (slash == 0 || expression.text.substr(slash) != "/slice") {
      return error(expression, "expected a category or a category with /slice, found " + shown(expression));
    }
    return Domain::Member{expression.text.substr(0, slash), true};
  }

  std::string where_;
  std::vector<Variable> scope_;
};

}  // namespace

Result<Formula> parse_formula(std::string_view where, const Sexpr& expression, FormulaUse use,
                              const std::vector<std::string>& bound) {
  const bool goal = use == FormulaUse::Goal;
  return Parser(where, bound).formula(expression, Place{!goal, goal, goal, false});
}

Result<Formula> parse_formula(std::string_view where, std::string_view text, FormulaUse use) {
  const auto expression = read_sexpr(where, text);
  if (!expression) return expression.error();
  return parse_formula(where, *expression, use);
}

}  // namespace unietp
