#include "interchange/virtualhome_words.h"

#include "core/text.h"

namespace unietp {

std::string room_type_of_virtualhome(std::string_view class_name, const FormatFacts& facts) {
  std::string name = lower(class_name);
  for (const auto& room : facts.virtualhome_rooms) {
    if (room.word == name) return room.ours;
  }
  return name;
}

std::string virtualhome_room_name(std::string_view type, const FormatFacts& facts) {
  for (const auto& room : facts.virtualhome_rooms) {
    if (room.ours == type) return room.word;
  }
  return std::string(type);
}

std::optional<State> state_of_virtualhome(std::string_view name, const FormatFacts& facts) {
  for (const auto& state : facts.virtualhome_states) {
    if (state.word == name) return State{state.ours, ""};
  }
  return std::nullopt;
}

std::string_view virtualhome_state(Predicate predicate, const FormatFacts& facts) {
  for (const auto& state : facts.virtualhome_states) {
    if (state.ours == predicate) return state.word;
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
