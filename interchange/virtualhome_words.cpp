#include "interchange/virtualhome_words.h"

#include "core/text.h"

namespace unietp {
namespace {

struct RoomWord {
  std::string_view class_name, type;
};
constexpr std::array<RoomWord, 6> kRooms{{{"livingroom", "living_room"},
                                          {"diningroom", "dining_room"},
                                          {"dining_room", "dining_room"},
                                          {"home_office", "office"},
                                          {"hallway", "corridor"},
                                          {"entrance_hall", "corridor"}}};

struct StateWord {
  std::string_view name;
  Predicate predicate;
};
constexpr std::array<StateWord, 8> kStates{{{"OPEN", Predicate::Open},
                                            {"CLOSED", Predicate::Closed},
                                            {"ON", Predicate::PowerOn},
                                            {"OFF", Predicate::PowerOff},
                                            {"CLEAN", Predicate::Clean},
                                            {"DIRTY", Predicate::Dirty},
                                            {"PLUGGED_IN", Predicate::PluggedIn},
                                            {"PLUGGED_OUT", Predicate::Unplugged}}};

}  // namespace

std::string room_type_of_virtualhome(std::string_view class_name) {
  const std::string name = lower(class_name);
  for (const RoomWord& word : kRooms) {
    if (word.class_name == name) return std::string(word.type);
  }
  return name;
}

std::string virtualhome_room_name(std::string_view type) {
  for (const RoomWord& word : kRooms) {
    if (word.type == type) return std::string(word.class_name);
  }
  return std::string(type);
}

std::optional<State> state_of_virtualhome(std::string_view name) {
  for (const StateWord& word : kStates) {
    if (word.name == name) return State{word.predicate, ""};
  }
  return std::nullopt;
}

std::string_view virtualhome_state(Predicate predicate) {
  for (const StateWord& word : kStates) {
    if (word.predicate == predicate) return word.name;
  }
  return {};
}

std::string virtualhome_group(const Category& category, const Knowledge& knowledge) {
  const auto can = [&](std::string_view affordance) { return knowledge.has(category.name, affordance); };
  if (category.archetype == Archetype::Panel) return category.name == "window" ? "Windows" : "Decor";
  if (category.movable && (can("consumable") || can("sliceable") || can("cookable"))) return "Food";
  if (can("switchable")) {
    if (category.name.find("lamp") != std::string::npos) return "Lamps";
    return can("openable") || can("heat_source") || can("cold_source") ? "Appliances" : "Electronics";
  }
  return category.movable ? "Props" : "Furniture";
}

}  // namespace unietp
