#pragma once

#include <string>
#include <vector>

#include "logic/vocabulary.h"

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
/// {Closed, Open}, {PowerOff, PowerOn}, {Clean, Dirty}, {RoomTemperature, Hot, Cool}, {Raw, Cooked}, {Unburnt, Burnt},
/// {Thawed, Frozen}, {Whole, Sliced}, {Empty, Filled}, {Dry, Soaked}, {Unused, UsedUp}, {Intact, Broken},
/// {Unfolded, Folded}, {Unplugged, PluggedIn}.
const std::vector<StateGroup>& state_groups();

/// Sorted states with the exclusive groups kept: setting `hot` takes `cool` away.
class StateSet {
 public:
  void set(State state);
  void clear(Predicate predicate);
  bool has(Predicate predicate) const;
  bool has(const State& state) const;
  const std::vector<State>& all() const { return states_; }
  bool operator==(const StateSet&) const = default;

 private:
  std::vector<State> states_;
};

}  // namespace unietp
