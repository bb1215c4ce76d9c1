#include "logic/vocabulary.h"

#include <array>
#include <cassert>

namespace unietp {
namespace {

using enum ArgumentKind;

constexpr std::array kObject = {Object};
constexpr std::array kObjectSymbol = {Object, Symbol};
constexpr std::array kObjectObject = {Object, Object};
constexpr std::array kObjectRoom = {Object, Room};

constexpr bool kByDefault = true, kTelling = true;

constexpr std::array<PredicateInfo, kPredicateCount> kPredicates = {{
    {Predicate::Open, "open", kObject, "?x is open", "openable", !kByDefault, kTelling},
    {Predicate::Closed, "closed", kObject, "?x is closed", "openable", kByDefault},
    {Predicate::PowerOn, "power_on", kObject, "?x is switched on", "switchable", !kByDefault, kTelling},
    {Predicate::PowerOff, "power_off", kObject, "?x is switched off", "switchable", kByDefault},
    {Predicate::Clean, "clean", kObject, "?x is clean", "dirtyable", kByDefault},
    {Predicate::Dirty, "dirty", kObject, "?x is dirty", "dirtyable", !kByDefault, kTelling},
    {Predicate::Hot, "hot", kObject, "?x is hot", "heatable", !kByDefault, kTelling},
    {Predicate::Cool, "cool", kObject, "?x is cold", "heatable", !kByDefault, kTelling},
    {Predicate::RoomTemperature, "room_temperature", kObject, "?x is neither hot nor cold", "heatable", kByDefault},
    {Predicate::Cooked, "cooked", kObject, "?x is cooked", "cookable", !kByDefault, kTelling},
    {Predicate::Raw, "raw", kObject, "?x is not cooked", "cookable", kByDefault},
    {Predicate::Burnt, "burnt", kObject, "?x is burnt", "burnable", !kByDefault, kTelling},
    {Predicate::Unburnt, "unburnt", kObject, "?x is not burnt", "burnable", kByDefault},
    {Predicate::Frozen, "frozen", kObject, "?x is frozen", "freezable", !kByDefault, kTelling},
    {Predicate::Thawed, "thawed", kObject, "?x is not frozen", "freezable", kByDefault},
    {Predicate::Sliced, "sliced", kObject, "?x is cut", "sliceable"},
    {Predicate::Whole, "whole", kObject, "?x is not cut", "sliceable", kByDefault},
    {Predicate::Empty, "empty", kObject, "nothing fills ?x", "fillable", kByDefault},
    {Predicate::Soaked, "soaked", kObject, "?x is soaked", "soakable", !kByDefault, kTelling},
    {Predicate::Dry, "dry", kObject, "?x is dry", "soakable", kByDefault},
    {Predicate::UsedUp, "used_up", kObject, "?x is used up", "consumable"},
    {Predicate::Unused, "unused", kObject, "?x is not used up", "consumable", kByDefault},
    {Predicate::Broken, "broken", kObject, "?x is broken", "breakable"},
    {Predicate::Intact, "intact", kObject, "?x is not broken", "breakable", kByDefault},
    {Predicate::Folded, "folded", kObject, "?x is folded", "foldable", !kByDefault, kTelling},
    {Predicate::Unfolded, "unfolded", kObject, "?x is not folded", "foldable", kByDefault},
    {Predicate::PluggedIn, "plugged_in", kObject, "?x is plugged in", "pluggable"},
    {Predicate::Unplugged, "unplugged", kObject, "?x is unplugged", "pluggable", kByDefault},
    {Predicate::Held, "held", kObject, "the agent holds ?x"},
    {Predicate::SatOn, "sat_on", kObject, "the agent sits on ?x"},
    {Predicate::LainOn, "lain_on", kObject, "the agent lies on ?x"},
    {Predicate::Read, "read", kObject, "the agent has read ?x"},
    {Predicate::Filled, "filled", kObjectSymbol, "?x holds this liquid; `any` asks for some liquid", "fillable"},
    {Predicate::Covered, "covered", kObjectSymbol, "?x is covered with this substance; `any` asks for some substance"},
    {Predicate::Color, "colour", kObjectSymbol, "?x has this color; fixed for a scene"},
    {Predicate::Material, "material", kObjectSymbol, "?x is made of this; fixed for a scene"},
    {Predicate::Size, "size", kObjectSymbol, "?x has this size among its kind; fixed for a scene"},
    {Predicate::On, "on", kObjectObject, "?x rests on ?y"},
    {Predicate::Inside, "inside", kObjectObject, "?x is inside ?y"},
    {Predicate::NextTo, "next_to", kObjectObject, "?x stands beside ?y"},
    {Predicate::Under, "under", kObjectObject, "?x is under ?y"},
    {Predicate::SliceOf, "slice_of", kObjectObject, "?x was cut from ?y"},
    {Predicate::Attached, "attached", kObjectObject, "?x is attached to ?y"},
    {Predicate::Nearest, "nearest", kObjectObject, "of the objects of its category, ?x is nearest to ?y"},
    {Predicate::OnFloor, "on_floor", kObjectRoom, "?x lies on the floor of room ?y"},
    {Predicate::InRoom, "in_room", kObjectRoom, "?x (or `agent`) is in room ?y"},
}};

constexpr bool in_order_of_the_enum() {
  for (std::size_t i = 0; i < kPredicates.size(); ++i) {
    if (static_cast<std::size_t>(kPredicates[i].predicate) != i) return false;
  }
  return true;
}
static_assert(in_order_of_the_enum());

constexpr std::array<AffordanceInfo, 24> kAffordances = {{
    {"burnable", "can be burnt"},
    {"breakable", "can be broken"},
    {"consumable", "can be used up"},
    {"container", "objects go into it"},
    {"cookable", "can be cooked"},
    {"coverable", "a substance can be spread on it"},
    {"dirtyable", "can be dirty, and cleaned"},
    {"drain", "what is poured into it is lost"},
    {"fillable", "can hold a liquid"},
    {"foldable", "can be folded"},
    {"freezable", "can be frozen"},
    {"heatable", "can be hot or cold"},
    {"heat_source", "makes other objects hot"},
    {"cold_source", "makes other objects cold"},
    {"lieable", "the agent can lie on it"},
    {"openable", "can be opened and closed"},
    {"pickupable", "the agent can carry it"},
    {"pluggable", "can be plugged in"},
    {"readable", "the agent can read it"},
    {"receptacle", "objects stand on it"},
    {"sittable", "the agent can sit on it"},
    {"sliceable", "can be cut into slices"},
    {"soakable", "can be soaked, as cloths and sponges are"},
    {"switchable", "can be switched on and off"},
}};

constexpr bool every_group_is_an_affordance() {
  for (const PredicateInfo& row : kPredicates) {
    bool found = row.group.empty();
    for (const AffordanceInfo& affordance : kAffordances) found = found || affordance.name == row.group;
    if (!found) return false;
  }
  return true;
}
static_assert(every_group_is_an_affordance());

}  // namespace

const PredicateInfo& info(Predicate predicate) {
  const auto index = static_cast<std::size_t>(predicate);
  assert(index < kPredicates.size());
  return kPredicates[index];
}

std::optional<Predicate> predicate_named(std::string_view name) {
  for (const auto& known : kPredicates) {
    if (known.name == name) return known.predicate;
  }
  return std::nullopt;
}

std::span<const PredicateInfo> all_predicates() { return kPredicates; }

std::span<const AffordanceInfo> all_affordances() { return kAffordances; }

}  // namespace unietp
