#include <algorithm>

#include "generator/start_draft.h"

// How one literal of a start constraint is made true or false of one object.
namespace unietp {
namespace {

using symbolic::PlaceKind;

}  // namespace

void StartDraft::make(const StartLiteral& literal, Id thing, bool truth) {
  if (!literal.relation) return make_state(literal, thing, truth);
  if (truth) return make_relation(literal, thing);
  constexpr int kTries = 8;
  for (int i = 0; i < kTries && is_true(literal, thing); ++i) move_anywhere(thing);
  if (is_true(literal, thing)) put(thing, PlaceKind::Floor, world().room);
}

bool StartDraft::set_attribute(const StartLiteral& literal, Id thing) {
  auto& role = start_.setting.objects.object(thing);
  const auto& kind = setting().kind_of(thing);
  const auto set = [&](std::string& own, std::vector<std::string> others) {
    own = literal.symbol == "any" ? "" : literal.symbol;
    if (is_true(literal, thing) == literal.positive) return;
    std::erase(others, own);
    own = others.empty() ? "" : rng_.pick(others);
  };
  if (literal.predicate == Predicate::Color) {
    set(role.color, kind.colors);
  } else if (literal.predicate == Predicate::Material) {
    set(role.material, kind.materials);
  } else if (literal.predicate == Predicate::Size) {
    set(role.size, {"small", "large"});
  } else {
    return false;
  }
  attributes_changed_ = true;
  return true;
}

void StartDraft::make_state(const StartLiteral& literal, Id thing, bool truth) {
  if (set_attribute(literal, thing)) return;
  auto& changed = world()[thing];
  const auto& symbols = demands_.rules.symbols();
  const auto number = demands_.rules.symbol_named(literal.symbol);
  if (literal.predicate == Predicate::Covered) {
    if (!truth) {
      number ? changed.coats.erase(*number) : changed.coats.clear();
    } else if (!symbols.empty()) {
      changed.coats.insert(number.value_or(symbolic::SubstanceId(rng_.below(symbols.size()))));
    }
    return;
  }
  for (const auto* group : setting().kind_of(thing).groups) {
    const auto& states = group->predicates;
    if (std::find(states.begin(), states.end(), literal.predicate) == states.end()) continue;
    auto state = literal.predicate;
    while (!truth && state == literal.predicate) state = rng_.pick(states);
    changed.set(state);
    if (state == Predicate::Filled)
      changed.filling = number.value_or(symbolic::SubstanceId(rng_.below(symbols.size())));
  }
}

void StartDraft::make_relation(const StartLiteral& literal, Id thing) {
  const auto& kind = setting().kind_of(thing);
  switch (literal.predicate) {
    case Predicate::OnFloor:
    case Predicate::InRoom: {
      const auto rooms = rooms_of(literal.other);
      if (rooms.empty()) return;
      // What stands on the floor of a room is in it; what is already in a home keeps its place now and then.
      const Id room = rng_.pick(rooms);
      const Id root = symbolic::root_of(world(), thing);
      const bool with_its_place = literal.predicate == Predicate::InRoom && rng_.chance(0.5);
      return put(with_its_place ? root : thing, PlaceKind::Floor, room);
    }
    case Predicate::On:
    case Predicate::Inside: {
      std::vector<Id> places;
      for (const Id place : things_of(literal.other)) {
        if (can_be_put(thing, literal.predicate, place)) places.push_back(place);
      }
      if (!places.empty())
        put(thing, literal.predicate == Predicate::On ? PlaceKind::On : PlaceKind::Inside, rng_.pick(places));
      return;
    }
    case Predicate::Nearest: {
      const Id root = symbolic::root_of(world(), thing);
      start_.setting.objects.object(root).spot_m = rng_.unit() * kHomeLength_m;
      return;
    }
    default: {
      auto others = things_of(literal.other);
      std::erase(others, thing);
      if (others.empty()) return;
      const Id other = rng_.pick(others);
      const bool under = literal.predicate == Predicate::Under;
      const auto& host = world()[other];
      if (!under && host.where == PlaceKind::Floor) {
        put(thing, PlaceKind::Floor, host.at);
      } else if (under) {
        put(thing, PlaceKind::Floor, symbolic::room_of(world(), other));
      } else if (kind.movable &&
                 can_be_put(thing, host.where == PlaceKind::On ? Predicate::On : Predicate::Inside, host.at)) {
        put(thing, host.where, host.at);
      } else {
        return move_anywhere(other);
      }
      world()[thing].beside = other;
      world()[thing].under = under;
    }
  }
}

}  // namespace unietp
