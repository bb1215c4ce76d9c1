#pragma once

#include "symbolic/heuristic.h"

namespace unietp::symbolic {

inline constexpr int kDeepestNeed = 4;  // needs of needs of needs

/// Estimates in one world what makes one atom true. Methods named `to_...` give an Estimate: of cost 0 when it is so
/// already. `depth`: how many needs of needs led here; deep ones are given up.
class AtomEstimator {
 public:
  AtomEstimator(const Setting& setting, const World& world) : setting_(setting), world_(world) {}

  /// What has to be done so that the atom is or is not true; kDeepestNeed needs of needs at most.
  Estimate to(const Atom& atom, bool wanted, int depth) const;

 private:
  bool offered(ActionType action) const { return setting_.rules->capabilities().has(action); }
  const Kind& kind(Id id) const { return setting_.kind_of(id); }
  /// Of the things that the atom is about, the one that does not exist yet; kNobody if all exist.
  Id missing_of(const Atom& atom) const;
  static Estimate after(Estimate need, int more) {
    if (need.possible()) need.cost += more;
    return need;
  }
  /// The step, once its needs are met.
  Estimate then(Estimate need, const Step& step) const;
  /// Nothing closed around it, and not in the hand.
  Estimate to_reach(Id id, int depth) const;
  Estimate to_hold(Id id, int depth) const;
  bool takes(Id id, Predicate relation, Id place) const;
  Estimate to_free_hand(int depth) const;
  Estimate to_place(Id id, Predicate relation, Id place, Id beside, int depth) const;
  Estimate to_attach(Id id, Id place, int depth) const;
  /// Something that is in the way is taken away.
  Estimate to_make_room(Id id, Predicate relation, Id place, int depth) const;
  Estimate to_room(Id room, bool wanted) const;
  Estimate to_drop(Id id, Id room, int depth) const;
  Estimate to_bring(Id id, Id room, int depth) const;
  Estimate to_neighbor(const Atom& atom, int depth) const;
  Estimate to_bring_beside(Id id, Id other, bool under, int depth) const;
  /// Brings both to a third place, where neither can go to the place of the other.
  Estimate to_bring_both(Id first, Id second, int depth) const;
  /// No longer beside or under each other.
  Estimate to_part(const Atom& atom, int depth) const;
  bool treats_by_power(Id tool, Id id) const;
  template <class Use>
  void each_tool(Treatment treatment, Id target, Use use) const {
    for (std::size_t i = 0; i < world_.things.size(); ++i) {
      const auto tool = Id::thing(i);
      if (tool == target || !world_[tool].exists) continue;
      const Reaction* reaction =
          setting_.rules->reaction(setting_.kind_number(tool), treatment, setting_.kind_number(target));
      if (reaction != nullptr) use(tool, *reaction);
    }
  }
  /// With a tool in hand, on something that is not.
  Estimate with_held(Id tool, ActionType action, Id target, Estimate need, int depth) const;
  Estimate to_cover(const Atom& atom, int depth) const;
  /// Wiped or washed: no dirt and nothing that covers it.
  Estimate to_clean(Id id, int depth) const;
  /// Held and treated with a tool, or put where the tool works by itself.
  void treated(Id id, Treatment treatment, std::optional<SubstanceId> symbol, int depth, Choice& ways) const;
  Estimate by_composite(Id id, Id tool, ActionType action, const Reaction& reaction, int depth) const;
  Estimate by_itself(Id id, Id tool, const Reaction& reaction, int depth) const;
  Estimate to_fill(Id id, std::optional<SubstanceId> symbol, int depth) const;
  Estimate to_empty(Id id, int depth) const;
  Estimate done_to(Id id, ActionType action, Estimate need, int depth, bool also_in_hand) const;
  /// Nothing rests on or in it.
  Estimate to_unload(Id id, int depth) const;
  /// By an action on the thing itself, with what the action needs first.
  Estimate directly(Id id, ActionType action, int depth) const;
  Estimate to_state(Id id, Predicate state, std::optional<SubstanceId> symbol, int depth) const;
  /// A state ends when another of its group begins.
  Estimate away_from(const Atom& atom, int depth) const;

  const Setting& setting_;
  const World& world_;
};

}  // namespace unietp::symbolic
