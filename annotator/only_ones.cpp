#include "annotator/only_ones.h"

#include <algorithm>

namespace unietp {
namespace {

using Op = Formula::Op;

bool is_only_one(const Domain& domain, std::span<const std::string> alone) {
  return domain.kind == Domain::Kind::Categories && domain.members.size() == 1 && !domain.members[0].slice &&
         domain.where.empty() && std::binary_search(alone.begin(), alone.end(), domain.members[0].category);
}

void name(Formula& formula, const std::string& variable, const Term& thing) {
  for (Term& term : formula.terms)
    if (term.kind == Term::Kind::Variable && term.name == variable) term = thing;
  if (formula.variable == variable) return;
  for (Formula& where : formula.domain.where) name(where, variable, thing);
  for (Formula& child : formula.children) name(child, variable, thing);
}

}  // namespace

Formula with_names_of_only_ones(const Formula& formula, std::span<const std::string> alone) {
  const bool binds = formula.op == Op::Exists || formula.op == Op::Forall;
  if (binds && is_only_one(formula.domain, alone)) {
    Formula body = formula.children[0];
    // No symbol has a colon.
    name(body, formula.variable, {Term::Kind::Symbol, ":" + formula.domain.members[0].category});
    return with_names_of_only_ones(body, alone);
  }
  Formula result = formula;
  for (Formula& where : result.domain.where) where = with_names_of_only_ones(where, alone);
  for (Formula& child : result.children) child = with_names_of_only_ones(child, alone);
  return result;
}

}  // namespace unietp
