#include "grounding/goal_places.h"

#include <algorithm>
#include <utility>

#include "logic/evaluate.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using Scope = std::vector<std::pair<std::string, const Domain*>>;

bool binds(Op op) { return op == Op::Forall || op == Op::Exists || op == Op::Count || op == Op::Number; }

std::vector<std::string> categories_bound_to(const Term& term, const Scope& scope) {
  std::vector<std::string> categories;
  if (term.kind != Term::Kind::Variable) return categories;
  const auto bound =
      std::find_if(scope.rbegin(), scope.rend(), [&](const auto& one) { return one.first == term.name; });
  if (bound == scope.rend()) return categories;
  for (const Domain::Member& member : bound->second->members) categories.push_back(member.category);
  return categories;
}

bool is_place(Predicate predicate) {
  using enum Predicate;
  return predicate == On || predicate == Inside || predicate == Under || predicate == NextTo || predicate == OnFloor ||
         predicate == InRoom;
}

void collect(const Formula& formula, Scope& scope, GoalPlaces& places) {
  if (formula.op == Op::Atom && formula.terms.size() == 2 && is_place(formula.predicate)) {
    for (const std::string& object : categories_bound_to(formula.terms[0], scope)) {
      for (const std::string& place : categories_bound_to(formula.terms[1], scope)) places[object].insert(place);
    }
  }
  if (binds(formula.op)) scope.emplace_back(formula.variable, &formula.domain);
  for (const Formula& child : formula.children) collect(child, scope, places);
  if (binds(formula.op)) scope.pop_back();
}

void collect(const Formula& formula, bool certain, std::vector<QuantifiedDomain>& domains) {
  if (binds(formula.op)) domains.push_back({formula.op, formula.variable, formula.domain, certain});
  const bool still = certain && formula.op != Op::Or && formula.op != Op::Not && formula.op != Op::Imply;
  for (const Formula& child : formula.children) collect(child, still, domains);
}

}  // namespace

bool makes_slices(const Domain& domain) {
  return std::any_of(domain.members.begin(), domain.members.end(), [](const auto& kind) { return kind.slice; });
}

GoalPlaces goal_places(const Formula& goal) {
  GoalPlaces places;
  Scope scope;
  collect(goal, scope, places);
  return places;
}

std::vector<QuantifiedDomain> quantified_domains(const Formula& formula) {
  std::vector<QuantifiedDomain> domains;
  collect(formula, true, domains);
  return domains;
}

std::vector<ReferredThings> referred_things(const Formula& goal, const Trace& trace) {
  std::vector<ReferredThings> found;
  for (QuantifiedDomain& one : quantified_domains(goal)) {
    if (one.domain.where.empty()) continue;
    if (free_variables(one.domain.where.front()) != std::vector<std::string>{one.variable}) continue;
    Domain all = one.domain;
    all.where.clear();
    auto referents = members_of(one.domain, one.variable, trace);
    auto others = members_of(all, one.variable, trace);
    std::erase_if(others, [&](EntityIndex entity) {
      return std::find(referents.begin(), referents.end(), entity) != referents.end();
    });
    found.push_back({std::move(one), std::move(referents), std::move(others)});
  }
  return found;
}

}  // namespace unietp
