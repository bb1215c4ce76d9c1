#include "report/formula_census.h"

#include <algorithm>

namespace unietp {
namespace {

std::string_view name_of_operator(Formula::Op op) {
  using Op = Formula::Op;
  switch (op) {
    case Op::Atom:
      return "";
    case Op::Equal:
      return "=";
    case Op::And:
      return "and";
    case Op::Or:
      return "or";
    case Op::Not:
      return "not";
    case Op::Imply:
      return "imply";
    case Op::Forall:
      return "forall";
    case Op::Exists:
      return "exists";
    case Op::Count:
    case Op::CountCompare:
      return "count";
    case Op::Number:
      return "number";
    case Op::AtEnd:
      return "at-end";
    case Op::Sometime:
      return "sometime";
    case Op::Always:
      return "always";
    case Op::Until:
      return "until";
    case Op::Before:
      return "before";
  }
  return "";
}

void collect(const Formula& formula, FormulaCensus& census) {
  if (formula.op == Formula::Op::Atom) {
    census.predicates.emplace(info(formula.predicate).name);
  } else {
    census.operators.emplace(name_of_operator(formula.op));
  }
  if (!formula.domain.where.empty()) census.operators.emplace("where");
  for (const Formula& where : formula.domain.where) collect(where, census);
  for (const Formula& child : formula.children) collect(child, census);
}

void collect_atoms(const Formula& formula, std::set<std::string>& atoms) {
  if (formula.op == Formula::Op::Atom) atoms.insert(to_text(formula));
  for (const Formula& where : formula.domain.where) collect_atoms(where, atoms);
  for (const Formula& child : formula.children) collect_atoms(child, atoms);
}

}  // namespace

int parts_of(const Formula& goal) {
  std::set<std::string> atoms;
  collect_atoms(goal, atoms);
  return std::max(1, static_cast<int>(atoms.size()));
}

FormulaCensus census_of(const Formula& goal) {
  FormulaCensus census;
  collect(goal, census);
  return census;
}

}  // namespace unietp
