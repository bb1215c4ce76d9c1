#pragma once

#include <optional>
#include <string>
#include <vector>

#include "logic/vocabulary.h"
#include "scene/simulator.h"

namespace unietp {

/// A truth about one object: a predicate and, for `filled` and `covered`, a symbol.
struct State {
  Predicate predicate = Predicate::Intact;
  std::string symbol;
  auto operator<=>(const State&) const = default;
};

/// States of which at most one holds of an object at a time; the first is the default of an object that has the group.
struct StateGroup {
  std::string affordance;             // a category with this affordance has the group ("openable", "dirtyable", …)
  std::vector<Predicate> predicates;  // {Closed, Open}
};
/// From the rows of logic/vocabulary.cpp, in the order of their first predicates.
const std::vector<StateGroup>& state_groups();

/// Whether the simulator shows a state of the vocabulary: VirtualHome and Habitat keep few, and a task must not refer
/// to an object by one that is not shown.
bool shows(Simulator simulator, Predicate state);

/// The other state of a group of two that need no symbol (Open: Closed); nullopt for other predicates.
std::optional<Predicate> opposite_of(Predicate state);

/// Sorted states with the exclusive groups kept: setting `hot` takes `cool` away.
class StateSet {
 public:
  /// Adds the state and removes the others of its group, if it has one (state_groups).
  void set(State state);
  /// Takes the predicate away, with every symbol.
  void clear(Predicate predicate);
  /// With any symbol.
  bool has(Predicate predicate) const;
  bool has(const State& state) const;
  /// Sorted by predicate, then by symbol.
  const std::vector<State>& all() const { return states_; }
  bool operator==(const StateSet&) const = default;

 private:
  std::vector<State> states_;
};

}  // namespace unietp
