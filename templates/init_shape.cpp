#include "templates/init_shape.h"

#include <algorithm>

namespace unietp {
namespace {

using Op = Formula::Op;

std::vector<Formula> literals_of(const Formula& formula) {
  const auto& body = formula.children.front();
  return body.op == Op::And ? body.children : std::vector<Formula>{body};
}

bool is_state_of(const Formula& formula, const std::string& variable) {
  if (formula.op != Op::Atom || formula.terms.empty()) return false;
  const auto kinds = info(formula.predicate).arguments;
  const bool unary = kinds.size() == 1 || (kinds.size() == 2 && kinds[1] == ArgumentKind::Symbol);
  return unary && formula.terms[0].kind == Term::Kind::Variable && formula.terms[0].name == variable;
}

/// `(in_room agent ?r)`, of a room.
bool is_where_the_agent_is(const Formula& formula, const std::string& variable) {
  return formula.op == Op::Atom && formula.predicate == Predicate::InRoom &&
         formula.terms[0].kind == Term::Kind::Agent && formula.terms[1].name == variable;
}

bool is_relation_of(const Formula& formula, const std::string& variable) {
  if (formula.op != Op::Exists || formula.children.front().op != Op::Atom) return false;
  if (!formula.domain.where.empty()) return false;
  const auto& inner = formula.children.front();
  using enum Predicate;
  const bool known = inner.predicate == On || inner.predicate == Inside || inner.predicate == OnFloor ||
                     inner.predicate == InRoom || inner.predicate == NextTo || inner.predicate == Under ||
                     inner.predicate == Nearest;
  return known && inner.terms.size() == 2 && inner.terms[0].kind == Term::Kind::Variable &&
         inner.terms[0].name == variable && inner.terms[1].kind == Term::Kind::Variable &&
         inner.terms[1].name == formula.variable;
}

const Formula& without_not(const Formula& literal) {
  return literal.op == Op::Not ? literal.children.front() : literal;
}

}  // namespace

std::optional<std::string> init_shape_problem(const Formula& formula) {
  const bool counted =
      formula.op == Op::Count && (formula.comparison == Comparison::AtLeast || formula.comparison == Comparison::Equal);
  if (!counted && formula.op != Op::Exists && formula.op != Op::Forall) {
    return "a start constraint is (exists (?x - A) body), (forall (?x - A) body), (count >= n (?x - A) body) or "
           "(count = n (?x - A) body)";
  }
  if (!formula.domain.where.empty())
    return "a start constraint must not have a ':where'; put the condition into the body";
  for (const auto& literal : literals_of(formula)) {
    const auto& inner = without_not(literal);
    const auto& variable = formula.variable;
    if (is_state_of(inner, variable) || is_relation_of(inner, variable) || is_where_the_agent_is(inner, variable)) {
      continue;
    }
    return "the body of a start constraint is made of states of ?" + formula.variable + " such as (open ?" +
           formula.variable + "), of relations such as (exists (?y - B) (on ?" + formula.variable +
           " ?y)), of (in_room agent ?" + formula.variable + "), and of (not ...) of these; got " + to_text(literal);
  }
  return std::nullopt;
}

std::vector<StartLiteral> start_literals(const Formula& formula) {
  std::vector<StartLiteral> literals;
  for (const auto& literal : literals_of(formula)) {
    const auto& inner = without_not(literal);
    StartLiteral read;
    read.positive = literal.op != Op::Not;
    read.relation = inner.op == Op::Exists;
    const auto& part = read.relation ? inner.children.front() : inner;
    read.predicate = part.predicate;
    if (read.relation) read.other = inner.domain;
    const bool symbol = part.terms.size() == 2 && part.terms[1].kind == Term::Kind::Symbol;
    if (symbol) read.symbol = part.terms[1].name;
    literals.push_back(std::move(read));
  }
  return literals;
}

int demanded_count(const Formula& formula) {
  if (formula.op == Op::Exists) return 1;
  return formula.op == Op::Count ? formula.number : 0;
}

}  // namespace unietp
