#include "interchange/own_ids.h"

#include <algorithm>
#include <string_view>

namespace unietp {
namespace {

constexpr std::string_view kRoom = "room|";  // of ProcTHOR

bool is_number(std::string_view text) {
  constexpr std::size_t kMostDigits = 9;
  return !text.empty() && text.size() <= kMostDigits &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// "cup_:0003" for "cup_3", as habitat-sim counts the instances of a template.
std::string handle_of(const std::string& instance) {
  const auto end = instance.rfind('_');
  if (end == std::string::npos) return "";
  std::string number = instance.substr(end + 1);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  return instance.substr(0, end) + "_:" + number;
}

/// The number of "plate.193" or "kitchen|2", when what is before the mark is this.
std::optional<std::string> number_after(const std::string& id, const std::string& stem, char mark) {
  if (!id.starts_with(stem + mark) || !is_number(std::string_view(id).substr(stem.size() + 1))) return std::nullopt;
  return id.substr(stem.size() + 1);
}

}  // namespace

std::string simulators_id(const SourceObject& object, Simulator simulator, const std::string& category) {
  switch (simulator) {
    case Simulator::Virtualhome:
      return is_number(object.id) ? category + "." + object.id : "";
    case Simulator::Habitat:
      return object.id.starts_with("box_") ? "" : handle_of(object.id);  // which a table of boxes has
    case Simulator::Ai2thor:
    case Simulator::Behavior:
      break;
  }
  return object.id;
}

std::optional<std::string> own_id_of(const Node& node, Simulator simulator) {
  const std::string& id = node.id;
  const auto has = [&](std::string_view part) { return id.find(part) != std::string::npos; };
  switch (simulator) {
    case Simulator::Virtualhome:
      return number_after(id, node.category, '.');
    case Simulator::Ai2thor:
      return has("|") ? std::optional(id) : std::nullopt;
    case Simulator::Habitat:
      return has("_:") ? std::optional(id) : std::nullopt;
    case Simulator::Behavior:
      break;
  }
  const auto dash = node.asset.rfind('-');  // "mug-ppzttc"
  return dash != std::string::npos && has("_" + node.asset.substr(dash + 1) + "_") ? std::optional(id) : std::nullopt;
}

std::string simulators_room_id(const std::string& type, const std::string& in_file, Simulator simulator) {
  if (simulator == Simulator::Virtualhome) return is_number(in_file) ? type + "." + in_file : "";
  if (simulator != Simulator::Ai2thor || !in_file.starts_with(kRoom)) return "";
  const std::string number = in_file.substr(kRoom.size());
  return is_number(number) ? type + "|" + number : "";
}

std::optional<std::string> own_id_of(const Room& room, Simulator simulator) {
  if (simulator == Simulator::Virtualhome) return number_after(room.id, room.type, '.');
  if (simulator != Simulator::Ai2thor) return std::nullopt;
  const auto number = number_after(room.id, room.type, '|');
  return number ? std::optional(std::string(kRoom) + *number) : std::nullopt;
}

}  // namespace unietp
