#include "annotator/trace_draft.h"

#include <algorithm>
#include <optional>

#include "logic/membership.h"
#include "scene/states.h"

namespace unietp {
namespace {

using Op = Formula::Op;
using P = Predicate;

constexpr EntityIndex kAgent(0);

/// Pairs of opposite states. A fact of the second is stored as the absence of the first.
const std::vector<std::pair<P, P>>& excluding() {
  static const auto pairs = [] {
    std::vector<std::pair<P, P>> all;
    for (const PredicateInfo& row : all_predicates()) {
      const auto other = opposite_of(row.predicate);
      if (other && row.predicate < *other) all.emplace_back(row.predicate, *other);
    }
    return all;
  }();
  return pairs;
}

std::optional<P> first_of(P second) {
  for (const auto& [one, other] : excluding())
    if (other == second) return one;
  return std::nullopt;
}

}  // namespace

TraceDraft::TraceDraft(const std::vector<const Formula*>& formulas, Rng rng) : rng_(rng) {
  for (const Formula* formula : formulas) collect(*formula);
  add({Entity::Kind::Agent, "agent", "agent", ""}, 1);
  add({Entity::Kind::Room, "room", "some other room", ""}, 1);
  add({Entity::Kind::Object, "thing", "some other thing", ""}, 1);
  for (const Formula* formula : formulas) add_entities(*formula);
  states_.resize(2 + rng_.below(4));
  for (const Entity& entity : entities_) {
    const bool late = !entity.slice_of.empty() && rng_.chance(0.3);
    since_.push_back(late ? rng_.below(states_.size()) : 0);
  }
  fill();
}

/// Collects kinds of facts, room categories, and the largest number of a count.
void TraceDraft::collect(const Formula& formula) {
  if (formula.op == Op::Atom) {
    const bool symbolic = !formula.terms.empty() && formula.terms.back().kind == Term::Kind::Symbol;
    const P kept = first_of(formula.predicate).value_or(formula.predicate);
    kinds_.insert({kept, symbolic ? formula.terms.back().name : ""});
  }
  if (formula.op == Op::Count) most_ = std::max(most_, formula.number);
  for (const Formula& where : formula.domain.where) collect(where);
  for (const Formula& child : formula.children) collect(child);
  const auto stands_for_room = [&](const Formula& f, const auto& self) -> bool {
    if (f.op == Op::Atom && (f.predicate == P::InRoom || f.predicate == P::OnFloor) && f.terms.size() == 2 &&
        f.terms[1].name == formula.variable)
      return true;
    const auto inside = [&](const Formula& part) { return self(part, self); };
    return std::any_of(f.children.begin(), f.children.end(), inside) ||
           std::any_of(f.domain.where.begin(), f.domain.where.end(), inside);
  };
  if (formula.variable.empty() || !stands_for_room(formula, stands_for_room)) return;
  for (const Domain::Member& member : formula.domain.members) rooms_.insert(member.category);
}

void TraceDraft::add(const Entity& entity, int copies) {
  for (int i = 0; i < copies; ++i) {
    Entity numbered = entity;
    numbered.id += std::to_string(entities_.size() + 1);
    entities_.push_back(std::move(numbered));
  }
}

void TraceDraft::add_entities(const Formula& formula) {
  for (const Domain::Member& member : formula.domain.members) {
    Domain alone;
    alone.members = {member};
    if (!members(alone).empty()) continue;
    const bool room = rooms_.contains(member.category);
    const Entity entity{room ? Entity::Kind::Room : Entity::Kind::Object, "e",
                        member.slice ? "slice of " + member.category : member.category,
                        member.slice ? member.category : ""};
    add(entity, most_ + 1 + static_cast<int>(rng_.below(2)));
  }
  for (const Formula& where : formula.domain.where) add_entities(where);
  for (const Formula& child : formula.children) add_entities(child);
}

TraceDraft::Fact TraceDraft::random_fact() {
  const auto kind = std::next(kinds_.begin(), static_cast<std::ptrdiff_t>(rng_.below(kinds_.size())));
  const bool two = info(kind->predicate).arguments.size() == 2 && kind->symbol.empty();
  const auto entity = [&] { return EntityIndex(rng_.below(entities_.size())); };
  const EntityIndex first = entity();
  return {kind->predicate, first, two ? entity() : kNone, kind->symbol};
}

void TraceDraft::fill() {
  if (kinds_.empty()) return;
  const std::uint64_t most = 1 + rng_.below(4 * entities_.size());
  for (std::uint64_t i = 0; i < most; ++i) set(0, random_fact(), true);
  for (std::size_t i = 1; i < states_.size(); ++i) {
    states_[i] = states_[i - 1];
    for (std::uint64_t k = rng_.below(4); k > 0; --k) set(i, random_fact(), rng_.chance(0.5));
  }
}

void TraceDraft::set(std::size_t position, const Fact& fact, bool value) {
  const auto& [predicate, first, second, symbol] = fact;
  if (first == kNone || (second == first)) return;
  const auto kept = first_of(predicate);
  Fact stored = fact;
  if (kept) std::get<0>(stored) = *kept;
  if (value != kept.has_value()) {
    states_[position].insert(stored);
  } else {
    states_[position].erase(stored);
  }
}

void TraceDraft::nudge() {
  if (kinds_.empty()) return;
  const Fact fact = random_fact();
  const bool value = rng_.chance(0.5);
  const std::size_t position = position_from(0);
  const bool everywhere = rng_.chance(0.3);
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (everywhere || i == position) set(i, fact, value);
}

std::vector<EntityIndex> TraceDraft::members(const Domain& domain) const {
  std::vector<EntityIndex> found;
  for (EntityIndex e; e.index() < entities_.size(); ++e)
    if (is_of(entities_[e], domain)) found.push_back(e);
  return found;
}

EntityIndex TraceDraft::value(const Term& term, const Scope& scope) const {
  if (term.kind == Term::Kind::Agent) return kAgent;
  for (auto i = scope.rbegin(); i != scope.rend(); ++i)
    if (i->first == term.name) return i->second;
  return kNone;
}

Trace TraceDraft::trace() const {
  Trace made;
  made.entities = entities_;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    Facts facts;
    const auto exists = [&](EntityIndex e) { return since_[e.index()] <= i; };
    for (EntityIndex e; e.index() < entities_.size(); ++e)
      if (exists(e)) facts.set_exists(e);
    for (const auto& [predicate, first, second, symbol] : states_[i]) {
      if (!exists(first)) continue;
      if (!symbol.empty()) {
        facts.set(predicate, first, symbol);
      } else if (second == kNone) {
        facts.set(predicate, first);
      } else if (exists(second)) {
        facts.set(predicate, first, second);
      }
    }
    for (const auto& [one, other] : excluding()) {
      if (!kinds_.contains({one, ""})) continue;
      for (EntityIndex e(3); e.index() < entities_.size(); ++e)  // entities other than objects have no such states
        if (exists(e) && entities_[e].kind == Entity::Kind::Object && !states_[i].contains({one, e, kNone, ""}))
          facts.set(other, e);
    }
    made.states.push_back(std::move(facts));
  }
  return made;
}

}  // namespace unietp
