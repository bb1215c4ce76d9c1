#include "interchange/own_ids.h"

#include <algorithm>
#include <string_view>

namespace unietp {
namespace {

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
    case Simulator::Virtualhome: {
      const std::string stem = node.category + ".";
      if (!id.starts_with(stem) || !is_number(std::string_view(id).substr(stem.size()))) return std::nullopt;
      return id.substr(stem.size());
    }
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

}  // namespace unietp
