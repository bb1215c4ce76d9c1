#include "grounding/upstream_homes.h"

#include <exception>
#include <map>
#include <set>
#include <sstream>

#include <nlohmann/json.hpp>

#include "akb/metadata_json.h"
#include "core/files.h"

namespace unietp {
namespace {

using Json = nlohmann::json;

/// What is known of names in a simulator's files.
struct Names {
  const Knowledge& knowledge;
  NameTexts rooms;  // our type of room, by a simulator's own
  StructureNames structure;

  /// "" when it is none of ours.
  std::string room_type(const std::string& name) const {
    const auto found = rooms.find(name);
    return found == rooms.end() ? std::string() : found->second;
  }
  /// The category that a name means ("kitchencabinets" is in the plural); nullptr when unknown or structure.
  const Category* category_of(const std::string& name) const {
    if (structure.contains(name)) return nullptr;
    const Category* category = knowledge.find(name);
    if (category == nullptr && name.ends_with('s')) category = knowledge.find(name.substr(0, name.size() - 1));
    return category;
  }
};

/// Unity's axes (y up) in ours (z up); mirrored, which no statistic sees.
Bounds box_of(const Json& center, const Json& size) {
  const Vec3 c(center.at(0).get<double>(), center.at(2).get<double>(), center.at(1).get<double>());
  const Vec3 s(size.at(0).get<double>(), size.at(2).get<double>(), size.at(1).get<double>());
  return {c - s / 2, c + s / 2};
}

std::vector<Vec2> outline_of(const Bounds& box) {
  return {{box.low.x(), box.low.y()},
          {box.high.x(), box.low.y()},
          {box.high.x(), box.high.y()},
          {box.low.x(), box.high.y()}};
}

HomeCensus ithor_home(const Json& scene, const Names& names) {
  CensusRoom room;
  room.type = names.room_type(scene.at("room"));
  std::map<std::string, std::string> type_of;
  for (const auto& object : scene.at("objects")) type_of[object.at("objectId")] = object.at("objectType");
  for (const auto& object : scene.at("objects")) {
    const std::string type = object.at("objectType");
    const bool boxed = object.contains("aabbCenter") && object.contains("aabbSize");
    if (type == "Floor" && boxed) room.outline = outline_of(box_of(object.at("aabbCenter"), object.at("aabbSize")));
    const Category* category = names.category_of(type);
    if (category == nullptr) continue;
    CensusObject one{category->name, category->movable, std::nullopt, {}};
    if (boxed) one.box = box_of(object.at("aabbCenter"), object.at("aabbSize"));
    if (object.contains("parentReceptacles")) {
      for (const auto& parent : object.at("parentReceptacles")) {
        const auto holder = type_of.find(parent.get<std::string>());
        if (holder != type_of.end() && !names.structure.contains(holder->second)) one.held_by.push_back(holder->second);
      }
    }
    room.objects.push_back(std::move(one));
  }
  return {{std::move(room)}};
}

/// Whole houses by their room types; objects are not read.
Result<std::vector<HomeCensus>> procthor_houses(const std::filesystem::path& path, const Names& names) {
  const auto text = read_maybe_gzip(path);
  if (!text) return text.error();
  std::vector<HomeCensus> houses;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    HomeCensus house;
    const Json json = Json::parse(line);
    for (const auto& room : json.at("rooms")) {
      house.rooms.push_back({names.room_type(room.at("roomType")), {}, {}});
    }
    houses.push_back(std::move(house));
  }
  return houses;
}

Result<UpstreamHomes> ai2thor_homes(const std::filesystem::path& folder, const Names& names) {
  UpstreamHomes all;
  const auto json = read_metadata_json(folder / "ithor_scenes.json.gz");
  if (!json) return json.error();
  all.source = "metadata:ithor_scenes.json.gz";
  for (const auto& [name, scene] : json->at("scenes").items()) all.homes.push_back(ithor_home(scene, names));
  auto houses = procthor_houses(folder / "procthor_houses_other.jsonl.gz", names);
  if (!houses) return houses.error();
  all.room_source = "metadata:procthor_houses_other.jsonl.gz";
  all.whole = std::move(*houses);
  return all;
}

HomeCensus virtualhome_home(const Json& graph, const Names& names) {
  HomeCensus home;
  std::map<int, std::size_t> room_of;  // node id → position in home.rooms
  std::map<int, std::string> class_of;
  for (const auto& node : graph.at("nodes")) {
    const int id = node.at("id");
    class_of[id] = node.at("class_name");
    if (node.at("category") != "Rooms" || names.room_type(class_of[id]).empty()) continue;
    room_of[id] = home.rooms.size();
    home.rooms.push_back(
        {names.room_type(class_of[id]), outline_of(box_of(node.at("bbox_center"), node.at("bbox_size"))), {}});
  }
  std::map<int, std::size_t> stands_in;
  std::map<int, std::vector<std::string>> held_by;
  for (const auto& edge : graph.at("edges")) {
    const int from = edge.at(0), to = edge.at(2);
    const std::string relation = edge.at(1);
    if (relation != "INSIDE" && relation != "ON") continue;
    if (const auto room = room_of.find(to); room != room_of.end()) {
      if (relation == "INSIDE") stands_in.emplace(from, room->second);
    } else if (const Category* holder = names.category_of(class_of[to])) {
      held_by[from].push_back(holder->name);
    }
  }
  for (const auto& node : graph.at("nodes")) {
    const int id = node.at("id");
    const auto room = stands_in.find(id);
    const Category* category = names.category_of(class_of[id]);
    if (room == stands_in.end() || category == nullptr) continue;
    home.rooms[room->second].objects.push_back(
        {category->name, category->movable, box_of(node.at("bbox_center"), node.at("bbox_size")), held_by[id]});
  }
  return home;
}

Result<UpstreamHomes> virtualhome_homes(const std::filesystem::path& folder, const Names& names) {
  UpstreamHomes all;
  for (int i = 1; i <= 6; ++i) {
    const auto graph = read_metadata_json(folder / "scenes" / ("TestScene" + std::to_string(i) + ".json.gz"));
    if (!graph) return graph.error();
    all.homes.push_back(virtualhome_home(*graph, names));
  }
  all.source = all.room_source = "metadata:scenes/TestScene1-6.json.gz";
  all.whole = all.homes;
  return all;
}

Result<UpstreamHomes> behavior_homes(const std::filesystem::path& folder, const Names& names) {
  UpstreamHomes all;
  const auto json = read_metadata_json(folder / "combined_room_object_list.json.gz");
  if (!json) return json.error();
  for (const auto& [name, rooms] : json->at("scenes").items()) {
    if (!name.ends_with("_int") && !name.starts_with("house_")) continue;
    HomeCensus home;
    for (const auto& [instance, models] : rooms.items()) {
      CensusRoom room{names.room_type(instance.substr(0, instance.rfind('_'))), {}, {}};
      if (room.type.empty()) continue;
      for (const auto& [model, count] : models.items()) {
        const Category* category = names.category_of(model.substr(0, model.rfind('-')));
        if (category == nullptr) continue;
        const CensusObject one{category->name, category->movable, std::nullopt, {}};
        room.objects.insert(room.objects.end(), static_cast<std::size_t>(std::max(0, count.get<int>())), one);
      }
      home.rooms.push_back(std::move(room));
    }
    all.homes.push_back(std::move(home));
  }
  all.source = all.room_source = "metadata:combined_room_object_list.json.gz";
  all.whole = all.homes;
  return all;
}

}  // namespace

Result<UpstreamHomes> upstream_homes(const std::filesystem::path& upstream, const std::filesystem::path& curated,
                                     const Knowledge& knowledge) {
  auto rooms = read_name_texts(curated / "room_names.csv");
  if (!rooms) return rooms.error();
  auto structure = read_structure_names(curated / "structure.csv");
  if (!structure) return structure.error();
  const Names names{knowledge, std::move(*rooms), std::move(*structure)};
  const auto folder = upstream / std::string(name_of(knowledge.simulator()));
  try {
    switch (knowledge.simulator()) {
      case Simulator::Ai2thor:
        return ai2thor_homes(folder, names);
      case Simulator::Virtualhome:
        return virtualhome_homes(folder, names);
      case Simulator::Behavior:
        return behavior_homes(folder, names);
      case Simulator::Habitat:
        return UpstreamHomes{};
    }
  } catch (const std::exception& failure) {  // nlohmann-json, when a file lacks a field or a field has another type
    return Error{Error::Kind::Schema,
                 folder.string(),
                 {},
                 std::string("scenes of another form than expected: ") + failure.what()};
  }
  return UpstreamHomes{};
}

}  // namespace unietp
