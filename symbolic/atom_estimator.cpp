#include "symbolic/atom_estimator.h"

#include <algorithm>

namespace unietp::symbolic {
namespace {

constexpr std::size_t kMostPlaces = 3;  // number of places that are tried where any place will do

Estimate one_step(const Step& step) {
  Estimate estimate{1, {}};
  estimate.steps.add(step);
  return estimate;
}

}  // namespace

Estimate AtomEstimator::to(const Atom& atom, bool wanted, int depth) const {
  if (holds(setting_, world_, atom.predicate, atom.first, atom.second, atom.symbol) == wanted) return {};
  if (depth > kDeepestNeed) return kUnreachable;
  if (atom.predicate == Predicate::InRoom && atom.first == kAgent) return to_room(atom.second, wanted);
  if (!atom.first.is_thing()) return kUnreachable;
  if (const auto missing = missing_of(atom); missing != kNobody && wanted) {
    return after(to_state(setting_.objects.object(missing).whole, Predicate::Sliced, kAnySymbol, depth), 2);
  }
  switch (atom.predicate) {
    case Predicate::Held:
      return wanted ? to_hold(atom.first, depth) : to_free_hand(depth);
    case Predicate::On:
    case Predicate::Inside:
      return wanted ? to_place(atom.first, atom.predicate, atom.second, kNobody, depth) : to_hold(atom.first, depth);
    case Predicate::Attached:
      return wanted ? to_attach(atom.first, atom.second, depth) : to_hold(atom.first, depth);
    case Predicate::SatOn:
    case Predicate::LainOn:
      return wanted ? to_state(atom.first, atom.predicate, kAnySymbol, depth) : then({}, {ActionType::StandUp});
    case Predicate::OnFloor:
      return wanted ? to_drop(atom.first, atom.second, depth) : to_hold(atom.first, depth);
    case Predicate::InRoom:
      return wanted ? to_bring(atom.first, atom.second, depth) : to_hold(atom.first, depth);
    case Predicate::NextTo:
    case Predicate::Under:
      return wanted ? to_neighbor(atom, depth) : to_part(atom, depth);
    case Predicate::Covered:
      return wanted ? to_cover(atom, depth) : to_clean(atom.first, depth);
    case Predicate::SliceOf:
    case Predicate::Nearest:
      return kUnreachable;
    default:
      return wanted ? to_state(atom.first, atom.predicate, atom.symbol, depth) : away_from(atom, depth);
  }
}

Id AtomEstimator::missing_of(const Atom& atom) const {
  for (const Id id : {atom.first, atom.second}) {
    if (id.is_thing() && !world_[id].exists) return id;
  }
  return kNobody;
}

Estimate AtomEstimator::then(Estimate need, const Step& step) const {
  if (!need.possible() || !offered(step.action)) return kUnreachable;
  if (need.cost == 0) {
    need.steps = {};
    need.steps.add(step);
  }
  need.cost += 1;
  return need;
}

Estimate AtomEstimator::to_reach(Id id, int depth) const {
  if (root_of(world_, id) == world_.held) return to_free_hand(depth + 1);
  const Id container = closed_around(setting_, world_, id);
  return container == kNobody ? Estimate{} : to_state(container, Predicate::Open, kAnySymbol, depth + 1);
}

Estimate AtomEstimator::to_hold(Id id, int depth) const {
  if (world_.held == id) return {};
  if (!kind(id).pickupable || depth > kDeepestNeed) return kUnreachable;
  Estimate need = to_reach(id, depth);
  if (world_.held != kNobody && root_of(world_, id) != world_.held) need = together(need, to_free_hand(depth + 1));
  return then(need, {ActionType::PickUp, id});
}

bool AtomEstimator::takes(Id id, Predicate relation, Id place) const {
  if (place == id || !world_[place].exists || root_of(world_, place) == id) return false;
  return has_room(setting_, world_, id, relation, place);
}

Estimate AtomEstimator::to_free_hand(int depth) const {
  if (world_.held == kNobody) return {};
  Estimate estimate{1, {}};
  if (offered(ActionType::Drop)) estimate.steps.add({ActionType::Drop});
  const Id id = world_.held;
  for (const bool furniture : {true, false}) {
    for (std::size_t i = 0; i < world_.things.size() && estimate.steps.size() <= kMostPlaces; ++i) {
      const auto place = Id::thing(i);
      if (kind(place).movable == furniture || closed_around(setting_, world_, place) != kNobody) continue;
      if (takes(id, Predicate::On, place)) estimate.steps.add({ActionType::PlaceOn, place});
      const bool open = !kind(place).openable || world_[place].has(Predicate::Open);
      if (open && takes(id, Predicate::Inside, place)) estimate.steps.add({ActionType::PlaceIn, place});
    }
  }
  if (!estimate.steps.empty()) return estimate;
  for (std::size_t i = 0; i < world_.things.size() && depth < kDeepestNeed; ++i) {
    const auto place = Id::thing(i);
    if (takes(id, Predicate::Inside, place)) return after(to_state(place, Predicate::Open, kAnySymbol, depth + 1), 1);
  }
  return kUnreachable;
}

Estimate AtomEstimator::to_place(Id id, Predicate relation, Id place, Id beside, int depth) const {
  const int fits = setting_.rules->capacity(setting_.kind_number(id), relation, setting_.kind_number(place));
  if (fits == 0 || id == place || depth > kDeepestNeed) return kUnreachable;
  Estimate need;
  if (!takes(id, relation, place) && root_of(world_, place) != id) need = to_make_room(id, relation, place, depth);
  if (world_.held != id && root_of(world_, place) == world_.held) {  // one put-down frees the hand for both
    if (!kind(id).pickupable) return kUnreachable;
    need = together(together(need, to_free_hand(depth + 1)), after(to_reach(id, depth), 1));
  } else {
    const bool into = relation == Predicate::Inside && kind(place).openable && !world_[place].has(Predicate::Open);
    need = together(need, into ? to_state(place, Predicate::Open, kAnySymbol, depth + 1) : to_reach(place, depth));
    if (world_.held != id) need = together(need, to_hold(id, depth));
  }
  const auto action = relation == Predicate::On ? ActionType::PlaceOn : ActionType::PlaceIn;
  const Estimate put = then(need, {action, place, beside});
  if (!treats_by_power(place, id)) return put;
  Choice ways;  // a running appliance treats what is put into it, wanted or not
  ways.add(put);
  ways.add(together(to_state(place, Predicate::PowerOff, kAnySymbol, depth + 1), put));
  return ways.estimate();
}

bool AtomEstimator::treats_by_power(Id tool, Id id) const {
  if (!kind(tool).switchable || !world_[tool].has(Predicate::PowerOn)) return false;
  const auto& reactions = setting_.rules->reactions(setting_.kind_number(tool), setting_.kind_number(id));
  return std::any_of(reactions.begin(), reactions.end(),
                     [](const Reaction& reaction) { return (reaction.needs & (kPowerOn | kUnderTap)) != 0; });
}

Estimate AtomEstimator::to_attach(Id id, Id place, int depth) const {
  const bool attaches =
      setting_.rules->capabilities().attaching &&
      setting_.rules->reaction(setting_.kind_number(place), Treatment::Attaches, setting_.kind_number(id)) != nullptr;
  if (!attaches) return kUnreachable;
  if (holds(setting_, world_, Predicate::On, id, place, kAnySymbol)) return after(to_hold(id, depth), 1);
  return to_place(id, Predicate::On, place, kNobody, depth);
}

Estimate AtomEstimator::to_make_room(Id id, Predicate relation, Id place, int depth) const {
  const PlaceKind where = relation == Predicate::On ? PlaceKind::On : PlaceKind::Inside;
  Choice ways;
  for (std::size_t i = 0; i < world_.things.size(); ++i) {
    const auto other = Id::thing(i);
    if (other == id || !world_[other].exists || world_[other].where != where || world_[other].at != place) continue;
    if (setting_.kind_number(other) != setting_.kind_number(id)) continue;  // other kinds take no room from it
    ways.add(after(to_hold(other, depth + 1), 1));
  }
  return ways.estimate();
}

Estimate AtomEstimator::to_room(Id room, bool wanted) const {
  if (wanted) return one_step({ActionType::GoTo, room});
  for (std::size_t r = 0; r < setting_.objects.rooms.size(); ++r) {
    const auto other = Id::room(r);
    if (other != room) return one_step({ActionType::GoTo, other});
  }
  return kUnreachable;
}

Estimate AtomEstimator::to_drop(Id id, Id room, int depth) const {
  Estimate need = to_hold(id, depth);
  if (world_.room != room) need = together(need, to_room(room, true));
  return then(need, {ActionType::Drop});
}

Estimate AtomEstimator::to_bring(Id id, Id room, int depth) const {
  Choice ways;
  for (std::size_t i = 0; i < world_.things.size() && ways.size() < kMostPlaces; ++i) {
    const auto place = Id::thing(i);
    if (kind(place).movable || !world_[place].exists || room_of(world_, place) != room) continue;
    for (const auto relation : {Predicate::On, Predicate::Inside}) {
      if (takes(id, relation, place)) ways.add(to_place(id, relation, place, kNobody, depth));
    }
  }
  ways.add(to_drop(id, room, depth));
  return ways.estimate();
}

Estimate AtomEstimator::to_neighbor(const Atom& atom, int depth) const {
  Choice ways;
  ways.add(to_bring_beside(atom.first, atom.second, atom.predicate == Predicate::Under, depth));
  if (atom.predicate == Predicate::NextTo) {
    ways.add(to_bring_beside(atom.second, atom.first, false, depth));
    if (ways.size() == 0) ways.add(to_bring_both(atom.first, atom.second, depth));
  }
  return ways.estimate();
}

Estimate AtomEstimator::to_bring_beside(Id id, Id other, bool under, int depth) const {
  const Thing& host = world_[other];
  if (host.where == PlaceKind::Floor) {
    Estimate need = together(to_hold(id, depth), to_reach(other, depth));
    if (need.possible() && world_.by != other) need = together(need, one_step({ActionType::GoTo, other}));
    return then(need, {ActionType::Drop, kNobody, other, under});
  }
  if (under || (host.where != PlaceKind::On && host.where != PlaceKind::Inside)) return kUnreachable;
  return to_place(id, host.where == PlaceKind::On ? Predicate::On : Predicate::Inside, host.at, other, depth);
}

Estimate AtomEstimator::to_bring_both(Id first, Id second, int depth) const {
  Choice ways;
  for (const Id id : {first, second}) {
    const Id other = id == first ? second : first;
    if (!kind(other).pickupable) continue;
    if (world_.room != kNobody) ways.add(after(to_drop(id, world_.room, depth), 2));
    for (std::size_t i = 0; i < world_.things.size(); ++i) {
      const auto place = Id::thing(i);
      if (takes(id, Predicate::On, place) && takes(other, Predicate::On, place))
        ways.add(after(to_place(id, Predicate::On, place, kNobody, depth), 2));
    }
  }
  return ways.estimate();
}

Estimate AtomEstimator::to_part(const Atom& atom, int depth) const {
  Choice ways;
  ways.add(to_hold(atom.first, depth));
  ways.add(to_hold(atom.second, depth));
  return ways.estimate();
}

Estimate toward(const Setting& setting, const World& world, const Atom& atom, bool wanted) {
  return AtomEstimator(setting, world).to(atom, wanted, 0);
}

}  // namespace unietp::symbolic
