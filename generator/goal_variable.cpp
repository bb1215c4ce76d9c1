#include "generator/goal_variable.h"

#include <algorithm>
#include <map>

namespace unietp {
namespace {

using Op = Formula::Op;

void count_categories(const Formula& formula, std::map<std::string, int>& uses) {
  if (!formula.variable.empty()) {
    for (const auto& member : formula.domain.members) ++uses[member.category];
    for (const auto& where : formula.domain.where) count_categories(where, uses);
  }
  for (const auto& child : formula.children) count_categories(child, uses);
}

void collect_outer(const Formula& formula, std::vector<GoalVariable>& found) {
  if (formula.op == Op::And) {
    for (const auto& child : formula.children) collect_outer(child, found);
  }
  if (formula.op != Op::Exists) return;
  const auto& domain = formula.domain;
  if (domain.kind == Domain::Kind::Categories && domain.members.size() == 1 && !domain.members[0].slice &&
      domain.where.empty()) {
    found.push_back({formula.variable, domain.members[0].category, Op::Exists, 1});
  }
  collect_outer(formula.children.front(), found);
}

/// Each one needed: `forall`, `count =` and `count >=`; under no negation, which would turn them round.
void collect_counted(const Formula& formula, std::vector<GoalVariable>& found) {
  const auto& domain = formula.domain;
  const bool plain = domain.kind == Domain::Kind::Categories && domain.members.size() == 1 &&
                     !domain.members[0].slice && domain.where.empty();
  const bool count = formula.op == Op::Count && formula.number >= 1 &&
                     (formula.comparison == Comparison::Equal || formula.comparison == Comparison::AtLeast);
  if (plain && (count || formula.op == Op::Forall)) {
    found.push_back({formula.variable, domain.members[0].category, formula.op, count ? formula.number : 2});
  }
  if (formula.op == Op::Not || formula.op == Op::Imply || formula.op == Op::CountCompare) return;
  for (const auto& child : formula.children) collect_counted(child, found);
}

void set_domain(Formula& formula, const GoalVariable& variable, const Domain& domain) {
  const bool same = formula.op == variable.quantifier && formula.variable == variable.variable;
  if (same && formula.domain == of_category(variable.category)) {
    formula.domain = domain;
    return;
  }
  for (auto& child : formula.children) set_domain(child, variable, domain);
}

void collect_bound(const Formula& formula, std::vector<std::string>& names) {
  if (!formula.variable.empty()) {
    names.push_back(formula.variable);
    for (const auto& where : formula.domain.where) collect_bound(where, names);
  }
  for (const auto& child : formula.children) collect_bound(child, names);
}

void collect_predicates(const Formula& formula, const std::string& variable, std::vector<Predicate>& found) {
  if (formula.op == Op::Atom) {
    for (const auto& term : formula.terms) {
      if (term.kind == Term::Kind::Variable && term.name == variable) found.push_back(formula.predicate);
    }
  }
  for (const auto& where : formula.domain.where) collect_predicates(where, variable, found);
  for (const auto& child : formula.children) collect_predicates(child, variable, found);
}

}  // namespace

std::vector<GoalVariable> singular_variables(const Formula& goal) {
  std::map<std::string, int> uses;
  count_categories(goal, uses);
  std::vector<GoalVariable> found;
  collect_outer(goal, found);
  std::erase_if(found, [&](const GoalVariable& variable) { return uses[variable.category] != 1; });
  return found;
}

std::vector<GoalVariable> counted_variables(const Formula& goal) {
  std::map<std::string, int> uses;
  count_categories(goal, uses);
  std::vector<GoalVariable> found;
  collect_counted(goal, found);
  std::erase_if(found, [&](const GoalVariable& variable) { return uses[variable.category] != 1; });
  return found;
}

Formula with_domain(const Formula& goal, const GoalVariable& variable, const Domain& domain) {
  auto changed = goal;
  set_domain(changed, variable, domain);
  return changed;
}

std::vector<std::string> bound_variables(const Formula& formula) {
  std::vector<std::string> names;
  collect_bound(formula, names);
  return names;
}

std::set<Predicate> predicates_in(const Formula& formula) {
  std::set<Predicate> found;
  if (formula.op == Op::Atom) found.insert(formula.predicate);
  for (const auto& child : formula.children) found.merge(predicates_in(child));
  return found;
}

std::vector<Predicate> predicates_of(const Formula& formula, const std::string& variable) {
  std::vector<Predicate> found;
  collect_predicates(formula, variable, found);
  return found;
}

}  // namespace unietp
