#include "scores/scored_parts.h"

#include <algorithm>
#include <array>
#include <utility>

namespace unietp {
namespace {

using Op = Formula::Op;

bool has(const Formula& formula, std::initializer_list<Op> operators) {
  return std::find(operators.begin(), operators.end(), formula.op) != operators.end() ||
         std::any_of(formula.children.begin(), formula.children.end(),
                     [&](const Formula& child) { return has(child, operators); });
}

bool is_inequality(const Formula& formula) {
  return formula.op == Op::Equal || (formula.op == Op::Not && formula.children.front().op == Op::Equal);
}

ScoredPartKind kind_of(const Formula& part) {
  if (has(part, {Op::Before})) return ScoredPartKind::Order;
  if (has(part, {Op::Always, Op::Until})) return ScoredPartKind::Constraint;
  if (has(part, {Op::Count, Op::CountCompare})) return ScoredPartKind::Count;
  return ScoredPartKind::State;
}

/// (before f g): both happen some time; (until f g): f stays, whether or not g comes.
Formula relaxed(Formula formula) {
  for (Formula& child : formula.children) child = relaxed(std::move(child));
  if (formula.op == Op::Before) {
    for (Formula& child : formula.children) {
      Formula some;
      some.op = Op::Sometime;
      some.children = {std::move(child)};
      child = std::move(some);
    }
    formula.op = Op::And;
  } else if (formula.op == Op::Until) {
    Formula stays, either;
    stays.op = Op::Always;
    stays.children = {formula.children.front()};
    either.op = Op::Or;
    either.children = {std::move(formula), std::move(stays)};
    return either;
  }
  return formula;
}

std::vector<Formula> split(const Formula& goal) {
  std::vector<Formula> parts;
  if (goal.op == Op::And) {
    for (const Formula& child : goal.children) {
      for (Formula& part : split(child)) parts.push_back(std::move(part));
    }
    return parts;
  }
  if (goal.op != Op::Exists && goal.op != Op::Forall && goal.op != Op::AtEnd) return {goal};
  for (Formula& inner : split(goal.children.front())) {
    if (is_inequality(inner)) continue;
    const auto free = free_variables(inner);
    const bool binds = goal.op == Op::AtEnd || std::find(free.begin(), free.end(), goal.variable) != free.end();
    if (!binds) {
      parts.push_back(std::move(inner));
      continue;
    }
    Formula around = goal;
    around.children = {std::move(inner)};
    parts.push_back(std::move(around));
  }
  return parts;
}

}  // namespace

std::string_view name_of(ScoredPartKind kind) {
  static constexpr std::array<std::string_view, 4> kNames{"state", "count", "order", "constraint"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool is_lost(const ScoredPart& part, bool met, bool relaxed_met) {
  if (met) return false;
  return part.kind == ScoredPartKind::Order ? relaxed_met : part.kind == ScoredPartKind::Constraint && !relaxed_met;
}

std::vector<ScoredPart> scored_parts(const Formula& goal) {
  std::vector<ScoredPart> parts;
  std::vector<Formula> known;
  for (Formula& part : split(goal)) {
    Formula normal = normal_form(part);
    if (std::find(known.begin(), known.end(), normal) != known.end()) continue;
    known.push_back(std::move(normal));
    const ScoredPartKind kind = kind_of(part);
    Formula other = relaxed(part);
    parts.push_back({kind, std::move(part), std::move(other)});
  }
  if (parts.empty()) parts.push_back({kind_of(goal), goal, relaxed(goal)});
  return parts;
}

}  // namespace unietp
