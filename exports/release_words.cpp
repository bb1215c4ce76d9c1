#include "exports/release_words.h"

#include <array>

#include "interchange/house_names.h"
#include "interchange/virtualhome_words.h"

namespace unietp {
namespace {

struct StateName {
  Predicate predicate;
  std::string_view name;
  bool ai2thor, virtualhome, habitat, behavior;  // their graph fills it
};

// BEHAVIOR's graph shows what is frozen as `cool`, so neither frozen nor thawed has a word of its own there.
constexpr std::array<StateName, 20> kStates{{
    {Predicate::Open, "open", true, true, true, true},
    {Predicate::Closed, "closed", true, true, true, true},
    {Predicate::PowerOn, "power_on", true, true, false, true},
    {Predicate::PowerOff, "power_off", true, true, false, true},
    {Predicate::Clean, "clean", true, false, false, true},
    {Predicate::Dirty, "dirty", true, false, false, true},
    {Predicate::Hot, "hot", true, false, false, true},
    {Predicate::Cool, "cool", true, false, false, false},
    {Predicate::RoomTemperature, "normal_temperature", true, false, false, false},
    {Predicate::Cooked, "cooked", true, false, false, true},
    {Predicate::Raw, "not_cooked", true, false, false, true},
    {Predicate::Burnt, "burnt", false, false, false, true},
    {Predicate::Unburnt, "not_burnt", false, false, false, true},
    {Predicate::Soaked, "saturated", false, false, false, true},
    {Predicate::Dry, "not_saturated", false, false, false, true},
    {Predicate::Empty, "no_liquid", true, false, false, true},
    {Predicate::Filled, "filled_with_liquid", true, false, false, true},
    {Predicate::UsedUp, "used_up", true, false, false, false},
    {Predicate::Broken, "broken", true, false, false, false},
    {Predicate::Covered, "covered", false, false, false, true},
}};

}  // namespace

std::string_view release_file(Simulator simulator) {
  switch (simulator) {
    case Simulator::Ai2thor:
      return "THOR.json";
    case Simulator::Virtualhome:
      return "VH.json";
    case Simulator::Habitat:
      return "Hab.json";
    case Simulator::Behavior:
      return "BEHAVIOR.json";
  }
  return "";
}

std::optional<std::string_view> release_state(Simulator simulator, Predicate predicate) {
  for (const StateName& state : kStates) {
    if (state.predicate != predicate) continue;
    const std::array filled{state.ai2thor, state.virtualhome, state.habitat, state.behavior};
    if (filled[static_cast<std::size_t>(simulator)]) return state.name;
  }
  return std::nullopt;
}

std::optional<std::string> release_room(Simulator simulator, std::string_view type, const FormatFacts& facts) {
  switch (simulator) {
    case Simulator::Ai2thor:
      return room_type_to_procthor(type);
    case Simulator::Virtualhome:
      return virtualhome_room_name(type, facts);
    case Simulator::Behavior:
      return std::string(type.substr(0, type.find('_')));  // of "living_room_0" what stands before the first "_"
    case Simulator::Habitat:
      return std::nullopt;
  }
  return std::nullopt;
}

bool says_on_and_inside(Simulator simulator) {
  return simulator == Simulator::Virtualhome || simulator == Simulator::Behavior;
}

bool says_rooms_of_objects(Simulator simulator) {
  return simulator == Simulator::Virtualhome || simulator == Simulator::Behavior;
}

}  // namespace unietp
