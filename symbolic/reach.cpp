#include "symbolic/reach.h"

#include <algorithm>

#include "scene/states.h"
#include "symbolic/perform.h"

namespace unietp::symbolic {
namespace {

std::uint64_t bit(Predicate state) { return std::uint64_t{1} << static_cast<unsigned>(state); }

/// Adds the state that a change brings about. What can never be in the state of `only_if` is in the other one already.
void add(const ActionChange& change, std::uint64_t& states) {
  if (!change.only_if || (states & bit(*change.only_if)) != 0) states |= bit(change.state);
}

bool needs_holding(const ActionInfo& action) {
  return std::any_of(action.needs.begin(), action.needs.end(),
                     [](const ActionNeed& need) { return need.kind == ActionNeed::Kind::InHand; });
}

}  // namespace

Reach::Reach(const Setting& setting, const World& start) : setting_(setting), start_(start) {
  outlooks_.resize(start.things.size());
  for (std::size_t i = 0; i < outlooks_.size(); ++i) {
    const Thing& thing = start.things[i];
    if (!thing.exists) continue;
    outlooks_[i].exists = true;
    outlooks_[i].states = thing.states;
    outlooks_[i].coats = thing.coats;
    if (thing.has(Predicate::Filled)) outlooks_[i].fillings.insert(thing.filling);
  }
  spread();
}

bool Reach::may_have(Id id, Predicate state) const { return (of(id).states & bit(state)) != 0; }

void Reach::spread() {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < outlooks_.size(); ++i) {
      if (!outlooks_[i].exists) continue;
      const auto id = Id::thing(i);
      Outlook next = outlooks_[i];
      do_alone(id, next);
      for (std::size_t k = 0; k < outlooks_.size(); ++k) {
        if (k != i && outlooks_[k].exists) do_with(Id::thing(k), id, next);
      }
      changed = changed || !(next == outlooks_[i]);
      outlooks_[i] = next;
    }
    for (std::size_t i = 0; i < outlooks_.size(); ++i) {  // a piece may have every state that its whole may have
      const Id whole = setting_.objects.things[i].whole;
      if (whole == kNobody || !may_have(whole, Predicate::Sliced)) continue;
      Outlook next = outlooks_[i];
      next.exists = true;
      next.states |= of(whole).states & ~(bit(Predicate::Sliced) | bit(Predicate::Whole));
      next.coats.insert(of(whole).coats);
      next.fillings.insert(of(whole).fillings);
      changed = changed || !(next == outlooks_[i]);
      outlooks_[i] = next;
    }
  }
}

void Reach::do_alone(Id id, Outlook& next) const {
  const Kind& kind = setting_.kind_of(id);
  if (kind.pickupable && offered(ActionType::PickUp)) next.held = true;
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      if (!action.direct || !offered(action.type) || !kind.allows(action.type)) continue;
      if (needs_holding(action) && !next.held) continue;
      for (const ActionChange& change : action.changes) add(change, next.states);
    }
  }
}

bool Reach::works(Id tool, Id target, const Reaction& reaction) const {
  if ((reaction.needs & kHeld) != 0) return false;
  const auto action = action_for(reaction.treatment);
  const bool composite = action && offered(*action);
  const bool runs = setting_.kind_of(tool).switchable && may_have(tool, Predicate::PowerOn);
  if ((reaction.needs & kUnderTap) != 0 && !composite && !runs) return false;
  if ((reaction.needs & kPowerOn) != 0 && setting_.kind_of(tool).switchable && !may_have(tool, Predicate::PowerOn))
    return false;
  if (holds(setting_, start_, Predicate::On, target, tool, kAnySymbol) ||
      holds(setting_, start_, Predicate::Inside, target, tool, kAnySymbol))
    return true;
  const auto relation = (reaction.needs & kOn) != 0 ? Predicate::On : Predicate::Inside;
  return may_be_at(target, relation, tool, 0);
}

void Reach::do_with(Id tool, Id target, Outlook& next) const {
  const Kind& kind = setting_.kind_of(target);
  for (const Reaction& reaction : setting_.rules->reactions(setting_.kind_number(tool), setting_.kind_number(target))) {
    const auto states = sets(reaction.treatment);
    if (!states.empty()) {
      if (!works(tool, target, reaction)) continue;
      for (const Predicate state : states) next.states |= bit(state);
      if (reaction.treatment == Treatment::Fills) next.fillings.insert(reaction.symbol);
      if (reaction.treatment == Treatment::Washes) next.uncovered = true;
      continue;
    }
    const auto by_hand = info(reaction.treatment).by_hand;
    if (!by_hand || !offered(*by_hand) || !of(tool).held) continue;
    for (const ActionChange& change : info(*by_hand).changes) {
      if (change.state == Predicate::Covered) {
        if (change.ends) next.uncovered = true;
        if (!change.ends) next.coats.insert(reaction.symbol);
      } else if (change.state != Predicate::Sliced || reaction.piece) {
        add(change, next.states);
      }
    }
  }
  if (!offered(ActionType::PourTo)) return;
  if (kind.fillable && of(tool).held && !of(tool).fillings.empty()) {
    next.fillings.insert(of(tool).fillings);
    next.states |= bit(Predicate::Filled);
  }
  const bool drains =
      setting_.kind_of(tool).drain || setting_.kind_of(tool).fillable ||
      setting_.rules->reaction(setting_.kind_number(tool), Treatment::Drains, setting_.kind_number(target)) != nullptr;
  if (drains && next.held && !next.fillings.empty()) next.states |= bit(Predicate::Empty);
}

bool Reach::may_be_at(Id id, Predicate relation, Id place, int depth) const {
  if (id == place || !of(id).exists || !of(place).exists) return false;
  if (holds(setting_, start_, relation, id, place, kAnySymbol)) return true;
  const auto fits = [&](Predicate how, Id where) {
    return setting_.rules->capacity(setting_.kind_number(id), how, setting_.kind_number(where)) > 0;
  };
  const auto action = relation == Predicate::On ? ActionType::PlaceOn : ActionType::PlaceIn;
  if (of(id).held && fits(relation, place) && offered(action)) return true;
  if (relation == Predicate::On || depth > 2) return false;
  for (std::size_t i = 0; i < outlooks_.size(); ++i) {  // indirectly, through something that is inside
    const auto between = Id::thing(i);
    if (between == id || between == place || !of(between).exists) continue;
    const bool there =
        start_[id].at == between || (of(id).held && (fits(Predicate::On, between) || fits(Predicate::Inside, between)));
    if (there && may_be_at(between, Predicate::Inside, place, depth + 1)) return true;
  }
  return false;
}

bool Reach::may(const Atom& atom, bool wanted) const {
  if (holds(setting_, start_, atom.predicate, atom.first, atom.second, atom.symbol) == wanted) return true;
  if (!wanted) return may_fail(atom);
  const auto exists = [&](Id id) { return !id.is_thing() || of(id).exists; };
  if (!exists(atom.first) || !exists(atom.second)) return false;
  if (atom.first == kAgent) return atom.predicate == Predicate::InRoom && offered(ActionType::GoTo);
  if (!atom.first.is_thing()) return false;
  const auto has_it = [&](const SubstanceSet& set) { return atom.symbol ? set.contains(*atom.symbol) : !set.empty(); };
  switch (atom.predicate) {
    case Predicate::Held:
      return of(atom.first).held;
    case Predicate::On:
    case Predicate::Inside:
      return may_be_at(atom.first, atom.predicate, atom.second, 0);
    case Predicate::Attached:
      return setting_.rules->capabilities().attaching && may_be_at(atom.first, Predicate::On, atom.second, 0) &&
             setting_.rules->reaction(setting_.kind_number(atom.second), Treatment::Attaches,
                                      setting_.kind_number(atom.first)) != nullptr;
    case Predicate::OnFloor:
      return of(atom.first).held && offered(ActionType::Drop);
    case Predicate::InRoom:
      return of(atom.first).held;
    case Predicate::NextTo:
      return of(atom.first).held || of(atom.second).held;
    case Predicate::Under:
      return of(atom.first).held && offered(ActionType::Drop);
    case Predicate::SliceOf:
      return setting_.objects.object(atom.first).whole == atom.second;
    case Predicate::Nearest:
      return true;  // the agent can move things apart
    case Predicate::Filled:
      return has_it(of(atom.first).fillings);
    case Predicate::Covered:
      return has_it(of(atom.first).coats);
    default:
      return may_have(atom.first, atom.predicate);
  }
}

bool Reach::may_fail(const Atom& atom) const {
  if (atom.first == kAgent) return setting_.objects.rooms.size() > 1;
  const auto moves = [&](Id id) {
    for (Id step = id;; step = start_[step].at) {
      if (of(step).held) return true;
      if (start_[step].where != PlaceKind::On && start_[step].where != PlaceKind::Inside) return false;
    }
  };
  switch (atom.predicate) {
    case Predicate::Held:
    case Predicate::Nearest:
      return true;
    case Predicate::SatOn:
    case Predicate::LainOn:
      return offered(ActionType::StandUp);
    case Predicate::On:
    case Predicate::Inside:
    case Predicate::Attached:
    case Predicate::OnFloor:
    case Predicate::InRoom:
    case Predicate::Under:
      return moves(atom.first);
    case Predicate::NextTo:
      return moves(atom.first) || moves(atom.second);
    case Predicate::Covered:
      return of(atom.first).uncovered;
    case Predicate::SliceOf:
      return false;
    default:
      break;
  }
  if (atom.predicate == Predicate::Filled && atom.symbol && of(atom.first).fillings.has_other_than(atom.symbol))
    return true;
  for (const StateGroup* group : setting_.kind_of(atom.first).groups) {
    const auto& states = group->predicates;
    if (std::find(states.begin(), states.end(), atom.predicate) == states.end()) continue;
    return std::any_of(states.begin(), states.end(),
                       [&](Predicate other) { return other != atom.predicate && may_have(atom.first, other); });
  }
  return false;
}

}  // namespace unietp::symbolic
