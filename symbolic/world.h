#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "logic/evaluate.h"
#include "logic/trace.h"
#include "symbolic/id.h"
#include "symbolic/rules.h"
#include "symbolic/substances.h"

namespace unietp::symbolic {

/// What never changes about a thing.
struct ObjectEntry {
  std::string id;
  KindId kind;
  Id whole = kNobody;                 // of a piece: what it is cut from
  std::string color, material, size;  // "" when not known
  double spot_m = 0;                  // of furniture: where it stands along its home, for `nearest`
};

/// Everything that takes part in a symbolic scene: things, among them the pieces that slicing could make, and rooms.
struct ObjectTable {
  std::vector<ObjectEntry> things;
  struct Room {
    std::string id, type;
  };
  std::vector<Room> rooms;
  /// By id, which must be a thing of this table, or a room.
  const ObjectEntry& object(Id thing) const { return things[thing.index()]; }
  ObjectEntry& object(Id thing) { return things[thing.index()]; }
  const Room& room(Id id) const { return rooms[id.index()]; }
  /// The thing or room of that name (ObjectEntry::id, Room::id), or kNobody.
  Id named(std::string_view name) const;
};

/// How a thing is at its place.
enum class PlaceKind : std::uint8_t { Floor, On, Inside, Hand };

/// What may change about a thing.
struct Thing {
  std::uint64_t states = 0;  // bit of each state that holds; of a filled thing that of Filled
  SubstanceSet coats;        // that cover it
  Id at = kNobody;           // the thing that it is on or in, or the room on whose floor it stands
  Id beside = kNobody;       // what it was set down next to, or under
  PlaceKind where = PlaceKind::Floor;
  SubstanceId filling;    // of a filled thing
  bool under = false;     // `beside` is what it lies under
  bool attached = false;  // to what it is on
  bool exists = true;
  bool operator==(const Thing&) const = default;
  bool has(Predicate state) const { return (states >> static_cast<unsigned>(state) & 1U) != 0; }
  /// Sets a state and takes away those that exclude it.
  void set(Predicate state);
  void clear(Predicate state) { states &= ~(std::uint64_t{1} << static_cast<unsigned>(state)); }
};

/// The state of everything at one moment: a value that is cheap to copy.
struct World {
  std::vector<Thing> things;
  Id held = kNobody;
  Id room = kNobody;  // the agent's
  Id by = kNobody;    // what the agent stands by: a thing on a floor; all that rests on or in it is in reach
  Id seat = kNobody;  // what the agent sits or lies on
  bool operator==(const World&) const = default;
  Thing& operator[](Id thing) { return things[thing.index()]; }
  const Thing& operator[](Id thing) const { return things[thing.index()]; }
};

/// A knowledge base and an object table: what stays the same while a world changes.
struct Setting {
  const Rules* rules = nullptr;  // outlives the setting
  ObjectTable objects;
  bool with_nearest = false;  // facts say which thing is nearest to which; quadratic, so only where a formula asks
  /// The kind of a thing, and its number.
  const Kind& kind_of(Id thing) const { return rules->kind(objects.object(thing).kind); }
  KindId kind_number(Id thing) const { return objects.object(thing).kind; }
};

/// A thing in the default states of its kind, on no floor yet.
Thing default_thing(const Kind& kind);
/// Adds the pieces that slicing could make of each sliceable thing with the tools that the cast has; they do not exist
/// yet. Call once, when all other things are in.
void add_pieces(Setting& setting, World& world);
/// Name of a thing, a room or the agent, for people.
const std::string& name_of(const Setting& setting, Id id);

/// The lowest thing below a thing, on the floor or in the hand: what the agent has to go to.
Id root_of(const World& world, Id thing);
/// Whether a thing is inside a container, directly or through others, as physics decides it.
bool is_inside(const World& world, Id thing, Id container);
/// Whether `upper` rests on or in `lower`, directly or through others.
bool rests_on(const World& world, Id upper, Id lower);
/// The outermost closed container around a thing, or kNobody.
Id closed_around(const Setting& setting, const World& world, Id thing);
/// The room whose floor a thing stands on or above, kNobody while it is in the hand.
Id room_of(const World& world, Id thing);
/// Whether an atom is true in a world. `second` is a thing, a room or kNobody; `symbol` a substance or kAnySymbol.
bool holds(const Setting& setting, const World& world, Predicate predicate, Id first, Id second,
           std::optional<SubstanceId> symbol);

/// The states of a sequence of worlds for the evaluators of the logic: entities are the things that exist in one of
/// them, the rooms, and the agent.
Trace trace_of(const Setting& setting, const std::vector<World>& worlds);
/// The same with all things, existing or not, so that entity i is thing i; then come the rooms.
Trace whole_trace_of(const Setting& setting, const World& world);

}  // namespace unietp::symbolic
