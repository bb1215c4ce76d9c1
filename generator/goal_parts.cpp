#include "generator/goal_parts.h"

#include <algorithm>

#include "scene/states.h"

namespace unietp {
namespace {

using Op = Formula::Op;

bool is_free_in(const std::string& variable, const Formula& formula) {
  const auto names = free_variables(formula);
  return std::find(names.begin(), names.end(), variable) != names.end();
}

Formula with_body(Formula quantifier, Formula body) {
  quantifier.children = {std::move(body)};
  return quantifier;
}

/// Empty hands, `(not (held ?x))` or `(count = 0 (?x - D) (held ?x))`, and `(not (= ?x ?y))`.
bool only_kept(const Formula& state) {
  const auto is_held = [](const Formula& f) { return f.op == Op::Atom && f.predicate == Predicate::Held; };
  if (state.op == Op::Equal) return true;
  if (state.op == Op::Not) return state.children[0].op == Op::Equal || is_held(state.children[0]);
  return state.op == Op::Count && state.number == 0 && is_held(state.children[0]) &&
         (state.comparison == Comparison::Equal || state.comparison == Comparison::AtMost);
}

void split(const Formula& formula, std::vector<Formula>& parts);

void split_quantified(const Formula& quantifier, std::vector<Formula>& parts) {
  std::vector<Formula> inner;
  split(quantifier.children.front(), inner);
  for (auto& part : inner) {
    parts.push_back(is_free_in(quantifier.variable, part) ? with_body(quantifier, std::move(part)) : std::move(part));
  }
}

void split_at_end(const Formula& formula, std::vector<Formula>& parts) {
  std::vector<Formula> inner;
  split(formula.children.front(), inner);
  for (auto& part : inner) parts.push_back(at_end(std::move(part)));
}

bool restores(const Formula& first, const Formula& second) {
  return first.op == Op::Sometime && second.op == Op::AtEnd &&
         exclude_each_other(first.children.front(), second.children.front());
}

void split_conjunction(const Formula& formula, std::vector<Formula>& parts) {
  std::vector<bool> done(formula.children.size(), false);
  for (std::size_t i = 0; i < formula.children.size(); ++i) {
    for (std::size_t j = 0; j < formula.children.size(); ++j) {
      if (done[i] || done[j] || !restores(formula.children[i], formula.children[j])) continue;
      parts.push_back(conjunction({formula.children[i], formula.children[j]}));
      done[i] = done[j] = true;
    }
  }
  for (std::size_t i = 0; i < formula.children.size(); ++i) {
    if (!done[i]) split(formula.children[i], parts);
  }
}

void split(const Formula& formula, std::vector<Formula>& parts) {
  if (formula.op == Op::And) {
    split_conjunction(formula, parts);
  } else if (formula.op == Op::Exists || formula.op == Op::Forall) {
    split_quantified(formula, parts);
  } else if (formula.op == Op::AtEnd) {
    split_at_end(formula, parts);
  } else if (formula.op != Op::Always && !only_kept(formula)) {
    parts.push_back(formula);
  }
}

}  // namespace

std::vector<Formula> goal_parts(const Formula& goal) {
  std::vector<Formula> parts;
  split(goal, parts);
  return parts;
}

bool exclude_each_other(const Formula& first, const Formula& second) {
  if (first.op != Op::Atom || second.op != Op::Atom || first.terms.empty() || second.terms.empty()) return false;
  if (first.predicate == second.predicate || !(first.terms[0] == second.terms[0])) return false;
  return std::any_of(state_groups().begin(), state_groups().end(), [&](const StateGroup& group) {
    const auto has = [&](Predicate p) {
      return std::find(group.predicates.begin(), group.predicates.end(), p) != group.predicates.end();
    };
    return has(first.predicate) && has(second.predicate);
  });
}

}  // namespace unietp
