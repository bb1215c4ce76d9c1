#include <algorithm>

#include "symbolic/atom_estimator.h"

namespace unietp::symbolic {
Estimate AtomEstimator::with_held(Id tool, ActionType action, Id target, Estimate need, int depth) const {
  if (!offered(action)) return kUnreachable;
  need = together(need, to_hold(tool, depth));
  if (world_.held != target || tool == target) need = together(need, to_reach(target, depth));
  return then(need, {action, target});
}

Estimate AtomEstimator::to_cover(const Atom& atom, int depth) const {
  Choice ways;
  each_tool(Treatment::Dispenses, atom.first, [&](Id tool, const Reaction& reaction) {
    if (!atom.symbol || *atom.symbol == reaction.symbol)
      ways.add(with_held(tool, ActionType::SpreadTo, atom.first, {}, depth));
  });
  return ways.estimate();
}

Estimate AtomEstimator::to_clean(Id id, int depth) const {
  Choice ways;
  treated(id, Treatment::Washes, kAnySymbol, depth, ways);
  each_tool(Treatment::Wipes, id, [&](Id tool, const Reaction&) {
    const auto dust = setting_.rules->symbol_named("dust");
    const bool wet = world_[id].coats.has_other_than(dust) || world_[id].has(Predicate::Dirty);
    Estimate need;
    if (wet && world_[tool].has(Predicate::Dry)) need = to_state(tool, Predicate::Soaked, kAnySymbol, depth + 1);
    ways.add(with_held(tool, ActionType::Wipe, id, need, depth));
  });
  return ways.estimate();
}

void AtomEstimator::treated(Id id, Treatment treatment, std::optional<SubstanceId> symbol, int depth,
                            Choice& ways) const {
  each_tool(treatment, id, [&](Id tool, const Reaction& reaction) {
    if ((reaction.needs & kHeld) != 0) return;
    if (treatment == Treatment::Fills && symbol && *symbol != reaction.symbol) return;
    const auto action = action_for(treatment);
    if (action && offered(*action)) ways.add(by_composite(id, tool, *action, reaction, depth));
    if ((reaction.needs & kUnderTap) == 0) ways.add(by_itself(id, tool, reaction, depth));
  });
}

Estimate AtomEstimator::by_composite(Id id, Id tool, ActionType action, const Reaction& reaction, int depth) const {
  const bool inside = (reaction.needs & (kInside | kUnderTap)) != 0;
  const auto relation = inside ? Predicate::Inside : Predicate::On;
  if (setting_.rules->capacity(setting_.kind_number(id), relation, setting_.kind_number(tool)) == 0)
    return kUnreachable;
  Estimate need = together(to_hold(id, depth), to_reach(tool, depth));
  if (!takes(id, relation, tool)) need = together(need, to_make_room(id, relation, tool, depth));
  const bool running = inside && kind(tool).openable && world_[tool].has(Predicate::PowerOn);
  if (running) need = together(need, to_state(tool, Predicate::PowerOff, kAnySymbol, depth + 1));
  return then(need, {action, tool});
}

Estimate AtomEstimator::by_itself(Id id, Id tool, const Reaction& reaction, int depth) const {
  const bool inside = (reaction.needs & kInside) != 0;
  const auto relation = inside ? Predicate::Inside : Predicate::On;
  const bool shut = (reaction.needs & kClosed) != 0 && kind(tool).openable;
  const bool power = (reaction.needs & kPowerOn) != 0 && kind(tool).switchable;
  const bool is_there = holds(setting_, world_, relation, id, tool, kAnySymbol);
  const int afterwards = (shut ? 1 : 0) + (power && !world_[tool].has(Predicate::PowerOn) ? 1 : 0);
  if (!is_there) {
    Estimate need;
    if (power && shut && world_[tool].has(Predicate::PowerOn)) {
      need = to_state(tool, Predicate::PowerOff, kAnySymbol, depth + 1);
      if (need.cost > 0) return after(need, 4);
    }
    return after(to_place(id, relation, tool, kNobody, depth), afterwards);
  }
  if (shut && !world_[tool].has(Predicate::Closed)) return to_state(tool, Predicate::Closed, kAnySymbol, depth + 1);
  if (power && !world_[tool].has(Predicate::PowerOn)) return to_state(tool, Predicate::PowerOn, kAnySymbol, depth + 1);
  return after(to_hold(id, depth), 2);  // it lies there already without effect, so it is taken out and put in again
}

Estimate AtomEstimator::to_fill(Id id, std::optional<SubstanceId> symbol, int depth) const {
  Choice ways;
  treated(id, Treatment::Fills, symbol, depth, ways);
  if (kind(id).fillable && offered(ActionType::PourTo)) {
    for (std::size_t i = 0; i < world_.things.size(); ++i) {
      const auto vessel = Id::thing(i);
      if (vessel == id || !world_[vessel].exists || !kind(vessel).fillable) continue;
      Estimate need;
      if (world_[id].has(Predicate::Filled)) need = to_state(id, Predicate::Empty, kAnySymbol, depth + 1);
      if (!holds(setting_, world_, Predicate::Filled, vessel, kNobody, symbol)) {
        Choice fillings;
        if (depth + 2 <= kDeepestNeed) treated(vessel, Treatment::Fills, symbol, depth + 2, fillings);
        need = together(need, fillings.estimate());
      }
      ways.add(with_held(vessel, ActionType::PourTo, id, need, depth));
    }
  }
  return ways.estimate();
}

Estimate AtomEstimator::to_empty(Id id, int depth) const {
  Choice drains, vessels;  // prefer a drain: pouring into another vessel fills that vessel
  for (std::size_t i = 0; i < world_.things.size(); ++i) {
    const auto target = Id::thing(i);
    if (target == id || !world_[target].exists) continue;
    const bool drain = kind(target).drain || setting_.rules->reaction(setting_.kind_number(target), Treatment::Drains,
                                                                      setting_.kind_number(id)) != nullptr;
    const bool takes_it = kind(target).fillable && world_[target].has(Predicate::Empty);
    if (drain || takes_it) (drain ? drains : vessels).add(with_held(id, ActionType::PourTo, target, {}, depth));
  }
  return drains.size() > 0 ? drains.estimate() : vessels.estimate();
}

Estimate AtomEstimator::done_to(Id id, ActionType action, Estimate need, int depth, bool also_in_hand) const {
  if (!also_in_hand || world_.held != id) need = together(need, to_reach(id, depth));
  return then(need, {action, id});
}

Estimate AtomEstimator::to_unload(Id id, int depth) const {
  for (std::size_t i = 0; i < world_.things.size(); ++i) {
    const auto other = Id::thing(i);
    if (world_[other].exists && other != id && rests_on(world_, other, id)) return after(to_hold(other, depth + 1), 1);
  }
  return {};
}

Estimate AtomEstimator::directly(Id id, ActionType action, int depth) const {
  using Kind = ActionNeed::Kind;
  if (!kind(id).allows(action)) return kUnreachable;
  const ActionInfo& about = info(action);
  const Predicate aim = about.changes.front().state;
  Estimate need;
  bool also_in_hand = false;
  for (const ActionNeed& one : about.needs) {
    if (!applies(setting_, world_, one.rule, id)) continue;
    const auto other = opposite_of(one.state);
    const bool own = one.state == aim || other == aim;  // that it is not so yet, which the caller knows
    if (one.kind == Kind::IsNot && !own && world_[id].has(one.state) && other)
      need = together(need, to_state(id, *other, kAnySymbol, depth + 1));
    if (one.kind == Kind::Is && !own && !world_[id].has(one.state))
      need = together(need, to_state(id, one.state, kAnySymbol, depth + 1));
    if (one.kind == Kind::HandFree && world_.held != kNobody) need = together(need, to_free_hand(depth + 1));
    if (one.kind == Kind::Unloaded && world_.held == kNobody) need = together(need, to_unload(id, depth));
    if (one.kind == Kind::InHand) need = together(need, to_hold(id, depth));
    also_in_hand = also_in_hand || one.kind == Kind::ReachOrInHand || one.kind == Kind::InHand;
  }
  return done_to(id, action, need, depth, also_in_hand);
}

Estimate AtomEstimator::to_state(Id id, Predicate state, std::optional<SubstanceId> symbol, int depth) const {
  if (depth > kDeepestNeed) return kUnreachable;
  Choice ways;
  if (const auto action = direct_action(state)) return directly(id, *action, depth);
  switch (state) {
    case Predicate::Sliced:
      if (!kind(id).sliceable) return kUnreachable;
      each_tool(Treatment::Slices, id,
                [&](Id tool, const Reaction&) { ways.add(with_held(tool, ActionType::Slice, id, {}, depth)); });
      return ways.estimate();
    case Predicate::Clean:
      return to_clean(id, depth);
    case Predicate::Filled:
      return to_fill(id, symbol, depth);
    case Predicate::Empty:
      return to_empty(id, depth);
    default:
      for (std::size_t t = 0; t < kTreatments; ++t) {
        const auto treatment = static_cast<Treatment>(t);
        const auto states = sets(treatment);
        if (std::find(states.begin(), states.end(), state) != states.end())
          treated(id, treatment, kAnySymbol, depth, ways);
      }
      return ways.estimate();
  }
}

Estimate AtomEstimator::away_from(const Atom& atom, int depth) const {
  for (const StateGroup* group : kind(atom.first).groups) {
    const auto& states = group->predicates;
    if (std::find(states.begin(), states.end(), atom.predicate) == states.end()) continue;
    Choice ways;
    for (const Predicate other : states) {
      if (other != atom.predicate) ways.add(to_state(atom.first, other, kAnySymbol, depth));
    }
    return ways.estimate();
  }
  return kUnreachable;
}

}  // namespace unietp::symbolic
