#include "logic/formula.h"

#include <algorithm>

namespace unietp {
namespace {

Formula quantified(Formula::Op op, std::string variable, Domain domain, Formula body) {
  Formula formula;
  formula.op = op;
  formula.variable = std::move(variable);
  formula.domain = std::move(domain);
  formula.children.push_back(std::move(body));
  return formula;
}

Formula unary(Formula::Op op, Formula part) {
  Formula formula;
  formula.op = op;
  formula.children.push_back(std::move(part));
  return formula;
}

void collect_categories(const Formula& formula, std::vector<std::string>& names) {
  for (const auto& member : formula.domain.members) names.push_back(member.category);
  for (const auto& where : formula.domain.where) collect_categories(where, names);
  for (const auto& child : formula.children) collect_categories(child, names);
}

void collect_free(const Formula& formula, std::vector<std::string>& bound, std::vector<std::string>& free) {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& term : formula.terms) {
    if (term.kind != Term::Kind::Variable || has(bound, term.name) || has(free, term.name)) continue;
    free.push_back(term.name);
  }
  const bool binds = !formula.variable.empty();
  if (binds) bound.push_back(formula.variable);
  for (const auto& where : formula.domain.where) collect_free(where, bound, free);
  for (const auto& child : formula.children) collect_free(child, bound, free);
  if (binds) bound.pop_back();
}

}  // namespace

// By hand: clang 14 crashes on the defaulted comparison of a type that holds itself.
bool Domain::operator==(const Domain& other) const {
  return kind == other.kind && members == other.members && where == other.where;
}

bool Formula::operator==(const Formula& other) const {
  return op == other.op && predicate == other.predicate && terms == other.terms && variable == other.variable &&
         comparison == other.comparison && number == other.number && domain == other.domain &&
         children == other.children;
}

bool is_temporal(Formula::Op op) {
  using enum Formula::Op;
  return op == AtEnd || op == Sometime || op == Always || op == Until || op == Before;
}

Formula atom(Predicate predicate, std::vector<std::string> variables) {
  Formula formula;
  formula.op = Formula::Op::Atom;
  formula.predicate = predicate;
  for (auto& name : variables) formula.terms.push_back({Term::Kind::Variable, std::move(name)});
  return formula;
}

Formula atom_with_symbol(Predicate predicate, std::string variable, std::string symbol) {
  Formula formula = atom(predicate, {std::move(variable)});
  formula.terms.push_back({Term::Kind::Symbol, std::move(symbol)});
  return formula;
}

Formula conjunction(std::vector<Formula> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  Formula formula;
  formula.op = Formula::Op::And;
  formula.children = std::move(parts);
  return formula;
}

Formula negation(Formula part) { return unary(Formula::Op::Not, std::move(part)); }

Formula exists(std::string variable, Domain domain, Formula body) {
  return quantified(Formula::Op::Exists, std::move(variable), std::move(domain), std::move(body));
}

Formula forall(std::string variable, Domain domain, Formula body) {
  return quantified(Formula::Op::Forall, std::move(variable), std::move(domain), std::move(body));
}

Formula at_end(Formula part) { return unary(Formula::Op::AtEnd, std::move(part)); }

Domain of_category(std::string category) {
  Domain domain;
  domain.members.push_back({std::move(category), false});
  return domain;
}

std::vector<std::string> categories_of(const Formula& formula) {
  std::vector<std::string> names;
  collect_categories(formula, names);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::vector<std::string> free_variables(const Formula& formula) {
  std::vector<std::string> bound, free;
  collect_free(formula, bound, free);
  return free;
}

const Formula* binder_of(const Formula& formula, const std::string& variable) {
  if (formula.variable == variable) return &formula;
  for (const std::vector<Formula>* parts : {&formula.domain.where, &formula.children})
    for (const Formula& part : *parts)
      if (const Formula* found = binder_of(part, variable)) return found;
  return nullptr;
}

}  // namespace unietp
