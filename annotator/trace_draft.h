#pragma once

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/rng.h"
#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// A made-up trace over the objects that two formulas speak of, before it is one: facts can be changed back, and a
/// formula can be pressed to be true or false in it. States that exclude each other (open, closed) do so here.
class TraceDraft {
 public:
  /// Three and more objects of each category that a formula names, one of no such category, rooms and the agent; two to
  /// five states, each a little different from the one before.
  TraceDraft(const std::vector<const Formula*>& formulas, Rng rng);

  /// Changes facts so that the formula has the wanted value at the start, by random choices. A later change may undo an
  /// earlier one, so the result is likely and not certain.
  void press(const Formula& formula, bool wanted);
  /// Changes one fact in one state, or in all of them.
  void nudge();
  Trace trace() const;

 private:
  using Scope = std::vector<std::pair<std::string, EntityIndex>>;
  struct Kind {  // of facts: what the formulas speak of
    Predicate predicate;
    std::string symbol;
    auto operator<=>(const Kind&) const = default;
  };
  static constexpr EntityIndex kNone = EntityIndex::none();
  using Fact = std::tuple<Predicate, EntityIndex, EntityIndex, std::string>;

  void collect(const Formula& formula);
  void add_entities(const Formula& formula);
  void add(const Entity& entity, int copies);
  void fill();
  Fact random_fact();
  void set(std::size_t position, const Fact& fact, bool value);
  std::vector<EntityIndex> members(const Domain& domain) const;
  EntityIndex value(const Term& term, const Scope& scope) const;
  void press(const Formula& formula, std::size_t position, bool wanted, Scope& scope);
  void press_atom(const Formula& formula, std::size_t position, bool wanted, const Scope& scope);
  void press_quantifier(const Formula& formula, std::size_t position, bool wanted, Scope& scope);
  void press_counts(const Formula& formula, std::size_t position, bool wanted, Scope& scope);
  void press_member(const Formula& binder, EntityIndex member, std::size_t position, bool wanted, Scope& scope);
  void press_number(const Formula& binder, int number, std::size_t position, Scope& scope);
  void press_over_time(const Formula& formula, std::size_t position, bool wanted, Scope& scope);
  std::size_t position_from(std::size_t position) { return position + rng_.below(states_.size() - position); }

  Rng rng_;
  std::set<Kind> kinds_;
  std::set<std::string> rooms_;  // categories that stand where a room is asked for
  int most_ = 2;                 // largest number that a count names
  EntityList entities_;
  std::vector<std::set<Fact>> states_;
  std::vector<std::size_t> since_;  // position from which an entity exists; slices may appear late
};

}  // namespace unietp
