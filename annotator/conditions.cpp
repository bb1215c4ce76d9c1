#include "annotator/conditions.h"

#include <algorithm>

#include "annotator/meaning.h"

namespace unietp {
namespace {

using Op = Formula::Op;

bool says_there_is(const Formula& start) {
  if (start.op == Op::Exists) return true;
  const bool enough = start.comparison == Comparison::AtLeast || start.comparison == Comparison::Equal;
  return start.op == Op::Count && enough && start.number >= 1;
}

Formula stripped(Formula goal, const std::vector<Formula>& excluded) {
  if (goal.op == Op::And || goal.op == Op::Exists)
    for (Formula& child : goal.children) child = stripped(std::move(child), excluded);
  if (goal.op != Op::Or) return goal;
  std::erase_if(goal.children, [&](const Formula& child) {
    return std::any_of(excluded.begin(), excluded.end(), [&](const Formula& f) { return same_expanded(child, f); });
  });
  if (goal.children.size() != 1) return goal;
  Formula only = std::move(goal.children.front());
  return only;
}

}  // namespace

std::vector<Formula> conditions_of(const std::vector<Formula>& start) {
  std::vector<Formula> found;
  const auto is_there = [&](const Domain& domain) {
    return std::any_of(start.begin(), start.end(),
                       [&](const Formula& f) { return says_there_is(f) && f.domain == domain; });
  };
  for (const Formula& f : start) {
    if (f.domain.kind != Domain::Kind::Categories || f.domain.members.empty()) continue;
    if (!says_there_is(f) && !(f.op == Op::Forall && is_there(f.domain))) continue;
    Domain domain = f.domain;
    domain.where = {f.children[0]};
    found.push_back(exists(f.variable, std::move(domain), Formula{}));
  }
  return found;
}

Formula without_conditions(const Formula& goal, const std::vector<Formula>& start) {
  std::vector<Formula> excluded;
  for (const Formula& condition : conditions_of(start)) excluded.push_back(expanded(negation(condition)));
  return excluded.empty() ? goal : expanded(stripped(goal, excluded));
}

}  // namespace unietp
