#include "symbolic/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace unietp::symbolic {
namespace {

std::uint64_t state_bit(Predicate state) { return std::uint64_t{1} << static_cast<unsigned>(state); }

/// By state: the states of its group, itself included.
const std::array<std::uint64_t, kPredicateCount>& group_masks() {
  static const auto kMasks = [] {
    std::array<std::uint64_t, kPredicateCount> masks{};
    for (const StateGroup& group : state_groups()) {
      std::uint64_t mask = 0;
      for (const Predicate state : group.predicates) mask |= state_bit(state);
      for (const Predicate state : group.predicates) masks[static_cast<std::size_t>(state)] = mask;
    }
    return masks;
  }();
  return kMasks;
}

double spot_of(const Setting& setting, const World& world, Id thing) {
  const Id root = root_of(world, thing);
  return setting.objects.object(root).spot_m + 1e-3 * static_cast<double>(thing.index());  // no two at the same spot
}

/// The nearest of the things of `thing`'s category to `other`, `other` itself aside.
bool is_nearest(const Setting& setting, const World& world, Id thing, Id other) {
  const double to = spot_of(setting, world, other);
  const auto away = [&](Id id) { return std::abs(spot_of(setting, world, id) - to); };
  for (std::size_t i = 0; i < world.things.size(); ++i) {
    const auto rival = Id::thing(i);
    if (rival == thing || rival == other || !world[rival].exists) continue;
    if (setting.kind_number(rival) != setting.kind_number(thing)) continue;
    if (away(rival) < away(thing)) return false;
  }
  return true;
}

/// Entity of each thing, or none.
using Entities = std::vector<EntityIndex>;
constexpr EntityIndex kNone = EntityIndex::none();

class FactWriter {
 public:
  FactWriter(const Setting& setting, const Entities& entities, std::size_t first_room)
      : setting_(setting), entities_(entities), first_room_(first_room) {}

  Facts read(const World& world) const {
    Facts facts;
    const std::size_t rooms = setting_.objects.rooms.size();
    for (std::size_t i = 0; i < world.things.size(); ++i) {
      if (world.things[i].exists) write(world, Id::thing(i), facts);
    }
    for (std::size_t r = 0; r < rooms; ++r) facts.set_exists(EntityIndex(first_room_ + r));
    const EntityIndex agent(first_room_ + rooms);
    facts.set_exists(agent);
    if (world.room != kNobody) facts.set(Predicate::InRoom, agent, room(world.room));
    return facts;
  }

 private:
  EntityIndex room(Id id) const { return EntityIndex(first_room_ + id.index()); }
  EntityIndex entity(Id id) const { return entities_[id.index()]; }

  void write(const World& world, Id id, Facts& facts) const {
    const auto& thing = world[id];
    const auto& role = setting_.objects.object(id);
    const auto me = entity(id);
    facts.set_exists(me);
    for (std::size_t p = 0; p < kPredicateCount; ++p) {
      const auto state = static_cast<Predicate>(p);
      if (state != Predicate::Filled && thing.has(state)) facts.set(state, me);
    }
    if (thing.has(Predicate::Filled))
      facts.set(Predicate::Filled, me, setting_.rules->symbols()[thing.filling.index()]);
    for (std::size_t s = 0; s < setting_.rules->symbols().size(); ++s) {
      if (thing.coats.contains(SubstanceId(s))) facts.set(Predicate::Covered, me, setting_.rules->symbols()[s]);
    }
    if (!role.color.empty()) facts.set(Predicate::Color, me, role.color);
    if (!role.material.empty()) facts.set(Predicate::Material, me, role.material);
    if (!role.size.empty()) facts.set(Predicate::Size, me, role.size);
    if (world.held == id) facts.set(Predicate::Held, me);
    write_relations(world, id, facts);
  }

  void write_relations(const World& world, Id id, Facts& facts) const {
    const auto& thing = world[id];
    const auto me = entity(id);
    const Id whole = setting_.objects.object(id).whole;
    if (whole != kNobody) facts.set(Predicate::SliceOf, me, entity(whole));
    if (thing.beside != kNobody) {
      facts.set(thing.under ? Predicate::Under : Predicate::NextTo, me, entity(thing.beside));
      if (!thing.under) facts.set(Predicate::NextTo, entity(thing.beside), me);
    }
    if (thing.where == PlaceKind::Floor) facts.set(Predicate::OnFloor, me, room(thing.at));
    if (thing.where == PlaceKind::On) facts.set(Predicate::On, me, entity(thing.at));
    if (thing.attached) facts.set(Predicate::Attached, me, entity(thing.at));
    for (Id step = id; world[step].where == PlaceKind::On || world[step].where == PlaceKind::Inside;
         step = world[step].at) {
      if (world[step].where == PlaceKind::Inside) facts.set(Predicate::Inside, me, entity(world[step].at));
    }
    const Id in = room_of(world, id);
    if (in != kNobody) facts.set(Predicate::InRoom, me, room(in));
    if (setting_.with_nearest) {
      for (std::size_t i = 0; i < world.things.size(); ++i) {
        const auto other = Id::thing(i);
        if (other != id && world[other].exists && is_nearest(setting_, world, id, other))
          facts.set(Predicate::Nearest, me, entity(other));
      }
    }
  }

  const Setting& setting_;
  const Entities& entities_;
  std::size_t first_room_;  // position of the first room among the entities
};

Entity entity_of(const Setting& setting, std::size_t i) {
  const ObjectEntry& role = setting.objects.things[i];
  const bool piece = role.whole != kNobody;
  return {Entity::Kind::Object, role.id, setting.rules->kind(role.kind).category,
          piece ? setting.kind_of(role.whole).category : ""};
}

Trace trace_with(const Setting& setting, const std::vector<World>& worlds, const std::vector<bool>& taken) {
  Trace trace;
  Entities entities(setting.objects.things.size(), kNone);
  for (std::size_t i = 0; i < entities.size(); ++i) {
    if (!taken[i]) continue;
    entities[i] = EntityIndex(trace.entities.size());
    trace.entities.push_back(entity_of(setting, i));
  }
  const std::size_t first_room = trace.entities.size();
  for (const auto& room : setting.objects.rooms) trace.entities.push_back({Entity::Kind::Room, room.id, room.type, ""});
  trace.entities.push_back({Entity::Kind::Agent, "agent", "agent", ""});
  const FactWriter writer(setting, entities, first_room);
  for (const World& world : worlds) trace.states.push_back(writer.read(world));
  return trace;
}

}  // namespace

void Thing::set(Predicate state) {
  states &= ~group_masks()[static_cast<std::size_t>(state)];
  states |= state_bit(state);
}

Thing default_thing(const Kind& kind) {
  Thing thing;
  for (const StateGroup* group : kind.groups) thing.set(group->predicates.front());
  return thing;
}

void add_pieces(Setting& setting, World& world) {
  const std::size_t wholes = world.things.size();
  for (std::size_t i = 0; i < wholes; ++i) {
    const KindId kind = setting.objects.things[i].kind;
    if (!setting.rules->kind(kind).sliceable) continue;
    const Reaction* most = nullptr;
    for (std::size_t k = 0; k < wholes; ++k) {
      const auto* cut = setting.rules->reaction(setting.objects.things[k].kind, Treatment::Slices, kind);
      if (cut != nullptr && cut->piece && (most == nullptr || cut->pieces > most->pieces)) most = cut;
    }
    for (int n = 0; most != nullptr && n < most->pieces; ++n) {
      ObjectEntry role;
      role.id = setting.objects.things[i].id + "_piece_" + std::to_string(n + 1);
      role.kind = *most->piece;
      role.whole = Id::thing(i);
      setting.objects.things.push_back(std::move(role));
      Thing piece;
      piece.exists = false;
      world.things.push_back(piece);
    }
  }
}

const std::string& name_of(const Setting& setting, Id id) {
  static const std::string kAgentName = "agent";
  if (!id.is_thing() && !id.is_room()) return kAgentName;
  return id.is_room() ? setting.objects.room(id).id : setting.objects.object(id).id;
}

Id ObjectTable::named(std::string_view name) const {
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].id == name) return Id::thing(i);
  }
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (rooms[i].id == name) return Id::room(i);
  }
  return kNobody;
}

Id root_of(const World& world, Id thing) {
  while (world[thing].where == PlaceKind::On || world[thing].where == PlaceKind::Inside) thing = world[thing].at;
  return thing;
}

bool is_inside(const World& world, Id thing, Id container) {
  for (Id step = thing; world[step].where == PlaceKind::On || world[step].where == PlaceKind::Inside;
       step = world[step].at) {
    if (world[step].where == PlaceKind::Inside && world[step].at == container) return true;
  }
  return false;
}

bool rests_on(const World& world, Id upper, Id lower) {
  for (Id step = upper; world[step].where == PlaceKind::On || world[step].where == PlaceKind::Inside;
       step = world[step].at) {
    if (world[step].at == lower) return true;
  }
  return false;
}

Id closed_around(const Setting& setting, const World& world, Id thing) {
  Id outermost = kNobody;
  for (Id step = thing; world[step].where == PlaceKind::On || world[step].where == PlaceKind::Inside;
       step = world[step].at) {
    const Id below = world[step].at;
    if (world[step].where == PlaceKind::Inside && setting.kind_of(below).openable && !world[below].has(Predicate::Open))
      outermost = below;
  }
  return outermost;
}

Id room_of(const World& world, Id thing) {
  const Thing& root = world[root_of(world, thing)];
  return root.where == PlaceKind::Floor ? root.at : kNobody;
}

bool holds(const Setting& setting, const World& world, Predicate predicate, Id first, Id second,
           std::optional<SubstanceId> symbol) {
  if (predicate == Predicate::InRoom && first == kAgent) return world.room == second;
  if (!first.is_thing() || !world[first].exists) return false;
  if (second.is_thing() && !world[second].exists) return false;
  const Thing& thing = world[first];
  switch (predicate) {
    case Predicate::Held:
      return world.held == first;
    case Predicate::On:
      return thing.where == PlaceKind::On && thing.at == second;
    case Predicate::Attached:
      return thing.attached && thing.at == second;
    case Predicate::Inside:
      return is_inside(world, first, second);
    case Predicate::OnFloor:
      return thing.where == PlaceKind::Floor && thing.at == second;
    case Predicate::InRoom:
      return room_of(world, first) == second;
    case Predicate::NextTo:
      return (thing.beside == second && !thing.under) || (world[second].beside == first && !world[second].under);
    case Predicate::Under:
      return thing.beside == second && thing.under;
    case Predicate::SliceOf:
      return setting.objects.object(first).whole == second;
    case Predicate::Nearest:
      return first != second && is_nearest(setting, world, first, second);
    case Predicate::Filled:
      return thing.has(Predicate::Filled) && (!symbol || thing.filling == *symbol);
    case Predicate::Covered:
      return symbol ? thing.coats.contains(*symbol) : !thing.coats.empty();
    default:
      return thing.has(predicate);
  }
}

Trace trace_of(const Setting& setting, const std::vector<World>& worlds) {
  std::vector<bool> taken(setting.objects.things.size(), false);
  for (const World& world : worlds) {
    for (std::size_t i = 0; i < taken.size(); ++i) taken[i] = taken[i] || world.things[i].exists;
  }
  return trace_with(setting, worlds, taken);
}

Trace whole_trace_of(const Setting& setting, const World& world) {
  return trace_with(setting, {world}, std::vector<bool>(setting.objects.things.size(), true));
}

}  // namespace unietp::symbolic
