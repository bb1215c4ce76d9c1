#include <cstdlib>

#include "annotator/trace_draft.h"
#include "logic/comparison.h"

namespace unietp {
namespace {

using Op = Formula::Op;

}  // namespace

void TraceDraft::enforce(const Formula& formula, bool wanted) {
  Scope scope;
  enforce(formula, 0, wanted, scope);
}

void TraceDraft::enforce(const Formula& formula, std::size_t position, bool wanted, Scope& scope) {
  switch (formula.op) {
    case Op::Atom:
      return enforce_atom(formula, position, wanted, scope);
    case Op::Equal:
    case Op::Number:
      return;
    case Op::Not:
      return enforce(formula.children[0], position, !wanted, scope);
    case Op::And:
    case Op::Or:
      if (formula.children.empty()) return;
      if ((formula.op == Op::And) != wanted)
        return enforce(formula.children[rng_.below(formula.children.size())], position, wanted, scope);
      for (const Formula& child : formula.children) enforce(child, position, wanted, scope);
      return;
    case Op::Imply:
      if (!wanted) {
        enforce(formula.children[0], position, true, scope);
        return enforce(formula.children[1], position, false, scope);
      }
      if (rng_.chance(0.5)) return enforce(formula.children[0], position, false, scope);
      return enforce(formula.children[1], position, true, scope);
    case Op::Forall:
    case Op::Exists:
      return enforce_quantifier(formula, position, wanted, scope);
    case Op::Count:
    case Op::CountCompare:
      return enforce_counts(formula, position, wanted, scope);
    default:
      return enforce_over_time(formula, position, wanted, scope);
  }
}

void TraceDraft::enforce_atom(const Formula& formula, std::size_t position, bool wanted, const Scope& scope) {
  const bool symbolic = formula.terms.back().kind == Term::Kind::Symbol;
  const bool two = formula.terms.size() == 2 && !symbolic;
  const Fact fact{formula.predicate, value(formula.terms[0], scope), two ? value(formula.terms[1], scope) : kNone,
                  symbolic ? formula.terms.back().name : ""};
  if (two && std::get<2>(fact) == kNone) return;
  set(position, fact, wanted);
}

void TraceDraft::enforce_member(const Formula& binder, EntityIndex member, std::size_t position, bool wanted,
                                Scope& scope) {
  scope.emplace_back(binder.variable, member);
  const bool there = wanted || rng_.chance(0.7);  // a member that does not exist fails a `:where`, too
  for (const Formula& where : binder.domain.where) enforce(where, 0, there, scope);
  if (wanted || there || binder.domain.where.empty()) enforce(binder.children[0], position, wanted, scope);
  scope.pop_back();
}

void TraceDraft::enforce_quantifier(const Formula& formula, std::size_t position, bool wanted, Scope& scope) {
  const auto all = members(formula.domain);
  if (all.empty()) return;
  const bool body = wanted;
  if ((formula.op == Op::Exists) == wanted) {  // one member is enough
    const EntityIndex member = all[rng_.below(all.size())];
    scope.emplace_back(formula.variable, member);
    for (const Formula& where : formula.domain.where) enforce(where, 0, true, scope);
    enforce(formula.children[0], position, body, scope);
    scope.pop_back();
    return;
  }
  for (const EntityIndex member : all) {
    scope.emplace_back(formula.variable, member);
    const bool holds = formula.domain.where.empty() || rng_.chance(0.6);
    for (const Formula& where : formula.domain.where) enforce(where, 0, holds, scope);
    if (holds) enforce(formula.children[0], position, body, scope);
    scope.pop_back();
  }
}

void TraceDraft::enforce_number(const Formula& binder, int number, std::size_t position, Scope& scope) {
  auto all = members(binder.domain);
  rng_.shuffle(all);
  for (std::size_t i = 0; i < all.size(); ++i)
    enforce_member(binder, all[i], position, static_cast<int>(i) < number, scope);
}

void TraceDraft::enforce_counts(const Formula& formula, std::size_t position, bool wanted, Scope& scope) {
  const bool compared = formula.op == Op::CountCompare;
  const auto size = [&](const Formula& binder) { return static_cast<int>(members(binder.domain).size()); };
  const Formula& first = compared ? formula.children[0] : formula;
  for (int tries = 0; tries < 16; ++tries) {
    const int left = static_cast<int>(rng_.below(static_cast<std::uint64_t>(size(first)) + 1));
    const int right = compared ? static_cast<int>(rng_.below(static_cast<std::uint64_t>(size(formula.children[1])) + 1))
                               : formula.number;
    // Numbers close to the bound distinguish comparisons.
    if (compares(left, formula.comparison, right) != wanted || std::abs(left - right) > 1 + tries / 4) continue;
    enforce_number(first, left, position, scope);
    if (compared) enforce_number(formula.children[1], right, position, scope);
    return;
  }
}

void TraceDraft::enforce_over_time(const Formula& formula, std::size_t position, bool wanted, Scope& scope) {
  const std::size_t last = states_.size() - 1;
  const auto from_to = [&](const Formula& part, std::size_t from, std::size_t end, bool value) {
    for (std::size_t i = from; i < end; ++i) enforce(part, i, value, scope);
  };
  const Formula& f = formula.children[0];
  const Formula& g = formula.children.back();
  const std::size_t at = position_from(position);
  switch (formula.op) {
    case Op::AtEnd:
      return enforce(f, last, wanted, scope);
    case Op::Sometime:
    case Op::Always:
      if ((formula.op == Op::Sometime) == wanted) return enforce(f, at, wanted, scope);
      return from_to(f, position, last + 1, wanted);
    case Op::Until:
      if (wanted) {
        from_to(f, position, at, true);
        return enforce(g, at, true, scope);
      }
      if (rng_.chance(0.4)) return from_to(g, position, last + 1, false);
      from_to(g, position, at + 1, false);
      return enforce(f, at, false, scope);
    case Op::Before: {
      if (!wanted && rng_.chance(0.3)) return from_to(rng_.chance(0.5) ? f : g, position, last + 1, false);
      // First times: `f` before `g`; to make it fail, `g` before or together with `f`.
      const Formula& sooner = wanted ? f : g;
      const Formula& later = wanted ? g : f;
      if (at == last && wanted) return from_to(g, position, last + 1, false);
      from_to(later, position, at + (wanted ? 1 : 0), false);
      from_to(sooner, position, at, false);
      enforce(sooner, at, true, scope);
      if (at < last) return enforce(later, at + 1 + rng_.below(last - at), true, scope);
      return enforce(later, at, true, scope);
    }
    default:
      return;
  }
}

}  // namespace unietp
