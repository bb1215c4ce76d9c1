#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace unietp {

/// Every state and relation that a goal, a start constraint, an effect rule or a scene can speak of.
enum class Predicate : std::uint8_t {
  // states of one object
  Open,
  Closed,
  PowerOn,
  PowerOff,
  Clean,
  Dirty,
  Hot,
  Cool,
  RoomTemperature,
  Cooked,
  Raw,
  Burnt,
  Unburnt,
  Frozen,
  Thawed,
  Sliced,
  Whole,
  Empty,
  Soaked,
  Dry,
  UsedUp,
  Unused,
  Broken,
  Intact,
  Folded,
  Unfolded,
  PluggedIn,
  Unplugged,
  // what the agent does with one object
  Held,
  SatOn,
  LainOn,
  Read,
  // states with a symbol
  Filled,
  Covered,
  // attributes with a symbol, fixed for a scene
  Color,
  Material,
  Size,
  // relations of two objects
  On,
  Inside,
  NextTo,
  Under,
  SliceOf,
  Attached,
  Nearest,
  // relations of an object and a room
  OnFloor,
  InRoom,
};
/// Number of predicates.
inline constexpr std::size_t kPredicateCount = static_cast<std::size_t>(Predicate::InRoom) + 1;

/// What may stand at one place of a predicate.
enum class ArgumentKind : std::uint8_t { Object, Room, Symbol };

/// All that is known of one predicate: a row of logic/vocabulary.cpp.
struct PredicateInfo {
  Predicate predicate;
  std::string_view name;  // "next_to"
  std::span<const ArgumentKind> arguments;
  std::string_view meaning;  // one line for people
  // Of states that exclude each other: the affordance of the categories that have them ("openable"); exactly one of the
  // group holds of their objects, `by_default` at first. Empty for other predicates.
  std::string_view group = {};
  bool by_default = false;
  bool telling = false;  // tells one object from another at a glance, and stays until the agent changes it
};

/// What can be done to the objects of a category, or what they can do: the states that they have and the actions that
/// they take part in.
struct AffordanceInfo {
  std::string_view name;     // "openable"
  std::string_view meaning;  // "can be opened and closed"
};

/// The row of a predicate. Every predicate has one.
const PredicateInfo& info(Predicate predicate);
/// The predicate of this name, or nullopt.
std::optional<Predicate> predicate_named(std::string_view name);
/// All predicates in the order of the enum.
std::span<const PredicateInfo> all_predicates();
/// All affordances that categories may have.
std::span<const AffordanceInfo> all_affordances();

}  // namespace unietp
