#include "logic/constraints.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace unietp {
namespace {

using Op = Formula::Op;

Formula of_one(Op op, Formula part) {
  Formula formula;
  formula.op = op;
  formula.children = {std::move(part)};
  return formula;
}

/// What is true as soon as the formula is false.
Formula opposite(Formula formula) {
  if (formula.op == Op::Count && formula.comparison == Comparison::Equal && formula.number == 0 &&
      formula.children.size() == 1) {
    formula.comparison = Comparison::AtLeast;
    formula.number = 1;
    return formula;
  }
  return of_one(Op::Not, std::move(formula));
}

bool has_always(const Formula& formula) {
  return formula.op == Op::Always || std::any_of(formula.children.begin(), formula.children.end(), has_always);
}

/// "Exactly n", with n not 0.
bool is_exactly_some(const Formula& formula) {
  return formula.op == Op::Count && formula.comparison == Comparison::Equal && formula.number > 0;
}

/// "At most n", with some allowed.
bool limits_from_above(const Formula& formula) {
  return formula.op == Op::Count && ((formula.comparison == Comparison::AtMost && formula.number > 0) ||
                                     (formula.comparison == Comparison::Less && formula.number > 1));
}

/// "As many of these as of those".
bool is_as_many(const Formula& formula) {
  return formula.op == Op::CountCompare && formula.comparison == Comparison::Equal;
}

/// Counts what a phrase tells from others: "exactly two of the red ones".
bool counts_some_of_a_kind(const Formula& formula) {
  return ((is_exactly_some(formula) || limits_from_above(formula)) && !formula.domain.where.empty()) ||
         std::any_of(formula.children.begin(), formula.children.end(), counts_some_of_a_kind);
}

/// The variable of the whole of which a variable is a slice, by a conjunct of the goal; "" when there is none.
std::string whole_of(const std::string& slice, const Formula& goal) {
  if (goal.op == Op::Atom && goal.predicate == Predicate::SliceOf && goal.terms[0].name == slice)
    return goal.terms[1].name;
  for (const Formula& child : goal.children)
    if (auto whole = whole_of(slice, child); !whole.empty()) return whole;
  return {};
}

/// What is said of slices said of their wholes: nothing can be done to a slice that is not cut yet.
Formula of_wholes(Formula formula, const Formula& goal) {
  for (Term& term : formula.terms) {
    auto whole = term.kind == Term::Kind::Variable ? whole_of(term.name, goal) : std::string();
    if (!whole.empty()) term.name = std::move(whole);
  }
  for (Formula& child : formula.children) child = of_wholes(std::move(child), goal);
  return formula;
}

/// The order of a `before` or `until` of a goal the other way around.
Formula reversed(const Formula& order, const Formula& goal) {
  Formula formula;
  formula.op = Op::Before;
  if (order.op == Op::Before)
    formula.children = {of_wholes(order.children[1], goal), order.children[0]};
  else
    formula.children = {opposite(order.children[0]), order.children[1]};
  return formula;
}

/// "All but the white ones": the part about all, and the one about those that it leaves out; nothing where it is no
/// such pair.
struct AllBut {
  const Formula *all = nullptr, *left_out = nullptr;
};
std::optional<AllBut> all_but(const Formula& pair) {
  if (pair.op != Op::And || pair.children.size() != 2) return std::nullopt;
  const Formula &all = pair.children[0], &stays = pair.children[1];
  if (all.op != Op::Forall || all.children[0].op != Op::AtEnd || all.domain.where.empty()) return std::nullopt;
  if (stays.op != Op::Always || stays.children[0].op != Op::Forall) return std::nullopt;
  const Formula& left_out = stays.children[0];
  const Formula& others = all.domain.where[0];
  const bool are_the_others = others.op == Op::Not && left_out.variable == all.variable &&
                              left_out.domain.members == all.domain.members && !left_out.domain.where.empty() &&
                              left_out.domain.where[0] == others.children[0];
  if (!are_the_others) return std::nullopt;
  return AllBut{&all, &left_out};
}

/// As many as are meant, with one among them that is to be left out.
std::optional<Formula> with_another_left_out(const Formula& pair) {
  const auto parts = all_but(pair);
  if (!parts) return std::nullopt;
  const auto [all, left_out] = *parts;
  const Formula& wanted = all->children[0].children[0];
  Formula done = *all, meant = *all, enough;
  done.op = meant.op = Op::Number;
  done.domain.where.clear();
  done.children = {wanted};
  meant.children = {conjunction({})};
  enough.op = Op::CountCompare;
  enough.comparison = Comparison::AtLeast;
  enough.children = {std::move(done), std::move(meant)};
  return conjunction({at_end(std::move(enough)), exists(all->variable, left_out->domain, at_end(wanted))});
}

/// The goal without its constraints, but with one of its parts changed: one formula for each part that changes.
std::vector<Formula> with_one_changed(const Formula& part,
                                      const std::function<std::optional<Formula>(const Formula&)>& change) {
  if (auto changed = change(part)) return {std::move(*changed)};
  if (part.op == Op::Before || part.op == Op::Until || part.op == Op::Always || part.op == Op::Not ||
      part.op == Op::Imply)
    return {};
  std::vector<Formula> all;
  for (std::size_t i = 0; i < part.children.size(); ++i) {
    for (Formula& inner : with_one_changed(part.children[i], change)) {
      Formula around = without_constraints(part);
      around.children[i] = std::move(inner);
      all.push_back(std::move(around));
    }
  }
  return all;
}

}  // namespace

Formula without_constraints(Formula goal) {
  switch (goal.op) {
    case Op::Always:
      return conjunction({});
    case Op::Before:
      return conjunction({of_one(Op::Sometime, without_constraints(std::move(goal.children[0]))),
                          of_one(Op::Sometime, without_constraints(std::move(goal.children[1])))});
    case Op::Until:
      return of_one(Op::Sometime, without_constraints(std::move(goal.children[1])));
    case Op::Not:
    case Op::Imply:
      return goal;  // less asked for inside is more asked for outside
    default:
      break;
  }
  if (limits_from_above(goal) || is_as_many(goal)) return conjunction({});
  if (is_exactly_some(goal)) goal.comparison = Comparison::AtLeast;
  for (Formula& child : goal.children) child = without_constraints(std::move(child));
  return goal;
}

Formula without_references(Formula goal) {
  goal.domain.where.clear();
  for (Formula& child : goal.children) child = without_references(std::move(child));
  return goal;
}

std::vector<Formula> with_an_order_reversed(const Formula& goal) {
  return with_one_changed(goal, [&goal](const Formula& part) -> std::optional<Formula> {
    if (part.op != Op::Before && part.op != Op::Until) return std::nullopt;
    return reversed(part, goal);
  });
}

std::vector<Formula> with_one_too_many(const Formula& goal) {
  const auto with_more = [&goal](Comparison unequal) {
    return with_one_changed(goal, [unequal](const Formula& part) -> std::optional<Formula> {
      Formula more = part;
      if (is_as_many(part)) {
        more.comparison = unequal;
        return more;
      }
      const bool counts = is_exactly_some(part) || limits_from_above(part);
      if (!counts || unequal == Comparison::Less) return std::nullopt;
      if (part.comparison != Comparison::Less) ++more.number;
      if (part.comparison != Comparison::Equal) more.comparison = Comparison::AtLeast;
      return more;
    });
  };
  std::vector<Formula> all = with_more(Comparison::Greater);
  for (Formula& one : with_more(Comparison::Less)) all.push_back(std::move(one));
  return all;
}

std::vector<HastyReading> hasty_readings(const Formula& goal) {
  const Formula asked = without_constraints(goal);
  if (asked == goal) return {};
  std::vector<HastyReading> readings{{asked}};
  for (Formula& one : with_one_too_many(goal)) readings.push_back({std::move(one), true});
  if (counts_some_of_a_kind(goal)) readings.push_back({without_references(asked)});
  for (Formula& one : with_one_changed(goal, with_another_left_out)) readings.push_back({std::move(one)});
  if (has_always(goal)) readings.push_back({without_references(asked)});
  return readings;
}

}  // namespace unietp
