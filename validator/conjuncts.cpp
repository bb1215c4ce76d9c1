#include "validator/conjuncts.h"

#include <algorithm>
#include <optional>

#include "scene/states.h"

namespace unietp {
namespace {

using Op = Formula::Op;

bool is_free_in(const std::string& variable, const Formula& formula) {
  const auto names = free_variables(formula);
  return std::find(names.begin(), names.end(), variable) != names.end();
}

bool is_held(const Formula& formula) { return formula.op == Op::Atom && formula.predicate == Predicate::Held; }

bool only_stays(const Formula& formula) {
  switch (formula.op) {
    case Op::Always:
    case Op::Equal:
      return true;
    case Op::Not:
      return formula.children[0].op == Op::Equal || is_held(formula.children[0]);
    case Op::Count:
      return formula.number == 0 && is_held(formula.children[0]) &&
             (formula.comparison == Comparison::Equal || formula.comparison == Comparison::AtMost);
    default:
      return false;
  }
}

/// Two states of which one object has at most one at a time.
bool are_opposites(const Formula& first, const Formula& second) {
  if (first.op != Op::Atom || second.op != Op::Atom || first.terms.empty() || first.terms != second.terms ||
      first.predicate == second.predicate)
    return false;
  const auto& groups = state_groups();
  return std::any_of(groups.begin(), groups.end(), [&](const StateGroup& group) {
    const auto& all = group.predicates;
    return std::find(all.begin(), all.end(), first.predicate) != all.end() &&
           std::find(all.begin(), all.end(), second.predicate) != all.end();
  });
}

/// Which conjunct is the second half of "sometime open, closed at the end", for one that is the first.
std::optional<std::size_t> restored_by(const std::vector<Formula>& parts, const Formula& part) {
  if (part.op != Op::Sometime) return std::nullopt;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].op == Op::AtEnd && are_opposites(part.children[0], parts[i].children[0])) return i;
  }
  return std::nullopt;
}

std::vector<Formula> of_conjunction(const std::vector<Formula>& parts) {
  std::vector<bool> paired(parts.size(), false);
  std::vector<Formula> all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto other = restored_by(parts, parts[i]);
    if (!other || paired[*other]) continue;
    paired[i] = paired[*other] = true;
    all.push_back(conjunction({parts[i], parts[*other]}));
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (paired[i]) continue;
    for (auto& inner : conjuncts_of(parts[i])) all.push_back(std::move(inner));
  }
  return all;
}

void collect(const Formula& formula, bool certain, std::vector<ReferringDomain>& domains) {
  if (!formula.domain.where.empty()) {
    auto others = free_variables(formula.domain.where.front());
    std::erase(others, formula.variable);
    if (others.empty()) domains.push_back({formula.variable, formula.domain, certain});
  }
  const bool still = certain && formula.op != Op::Or && formula.op != Op::Not && formula.op != Op::Imply;
  for (const Formula& child : formula.children) collect(child, still, domains);
}

}  // namespace

std::vector<Formula> conjuncts_of(const Formula& goal) {
  if (only_stays(goal)) return {};
  if (goal.op == Op::And) return of_conjunction(goal.children);
  if (goal.op != Op::Exists && goal.op != Op::Forall && goal.op != Op::AtEnd) return {goal};
  std::vector<Formula> all;
  for (auto& inner : conjuncts_of(goal.children.front())) {
    if (goal.op != Op::AtEnd && !is_free_in(goal.variable, inner)) {
      all.push_back(std::move(inner));
      continue;
    }
    Formula around = goal;
    around.children = {std::move(inner)};
    all.push_back(std::move(around));
  }
  return all;
}

std::vector<ReferringDomain> referring_domains(const Formula& goal) {
  std::vector<ReferringDomain> domains;
  collect(goal, true, domains);
  return domains;
}

}  // namespace unietp
