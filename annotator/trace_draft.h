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

/// An editable trace over the objects of two formulas: its facts can be changed so that a formula becomes true or
/// false. Mutually exclusive states (open, closed) stay exclusive.
class TraceDraft {
 public:
  /// At least three objects of each category of the formulas, one of another category, rooms and the agent; two to five
  /// states, each slightly different from the previous one.
  TraceDraft(const std::vector<const Formula*>& formulas, Rng rng);

  /// Changes facts so that the formula has the wanted value at the start, by random choices. A later change may undo an
  /// earlier one, so the result is likely and not certain.
  void enforce(const Formula& formula, bool wanted);
  /// Changes one fact in one state, or in all of them.
  void nudge();
  Trace trace() const;

 private:
  using Scope = std::vector<std::pair<std::string, EntityIndex>>;
  struct Kind {  // kinds of facts that the formulas contain
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
  void enforce(const Formula& formula, std::size_t position, bool wanted, Scope& scope);
  void enforce_atom(const Formula& formula, std::size_t position, bool wanted, const Scope& scope);
  void enforce_quantifier(const Formula& formula, std::size_t position, bool wanted, Scope& scope);
  void enforce_counts(const Formula& formula, std::size_t position, bool wanted, Scope& scope);
  void enforce_member(const Formula& binder, EntityIndex member, std::size_t position, bool wanted, Scope& scope);
  void enforce_number(const Formula& binder, int number, std::size_t position, Scope& scope);
  void enforce_over_time(const Formula& formula, std::size_t position, bool wanted, Scope& scope);
  std::size_t position_from(std::size_t position) { return position + rng_.below(states_.size() - position); }

  Rng rng_;
  std::set<Kind> kinds_;
  std::set<std::string> rooms_;  // categories that stand where a room is asked for
  int most_ = 2;                 // largest number that a count names
  EntityList entities_;
  std::vector<std::set<Fact>> states_;
  std::vector<std::size_t> since_;  // first state in which an entity exists; slices may appear later
};

}  // namespace unietp
