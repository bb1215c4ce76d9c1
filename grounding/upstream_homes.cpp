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

/// Our room type for a simulator's own, "" when it is none of ours.
std::string room_type(const std::string& name) {
  static const std::map<std::string, std::string> kTypes{
      {"Kitchen", "kitchen"},         {"LivingRoom", "living_room"},      {"Bedroom", "bedroom"},
      {"Bathroom", "bathroom"},       {"livingroom", "living_room"},      {"kitchen", "kitchen"},
      {"living_room", "living_room"}, {"television_room", "living_room"}, {"bedroom", "bedroom"},
      {"childs_room", "bedroom"},     {"bathroom", "bathroom"},           {"dining_room", "dining_room"},
      {"private_office", "office"},   {"corridor", "corridor"},           {"entryway", "corridor"}};
  const auto found = kTypes.find(name);
  return found == kTypes.end() ? std::string() : found->second;
}

/// The category that a simulator's name means ("kitchencabinets" is in the plural); nullptr when unknown or structure.
const Category* category_of(const Knowledge& knowledge, const std::string& name) {
  if (is_structure(name)) return nullptr;
  const Category* category = knowledge.find(name);
  if (category == nullptr && name.ends_with('s')) category = knowledge.find(name.substr(0, name.size() - 1));
  return category;
}

/// Unity's axes (y up) in ours (z up); mirrored, which no statistic sees.
Bounds box_of(const Json& centre, const Json& size) {
  const Vec3 c(centre.at(0).get<double>(), centre.at(2).get<double>(), centre.at(1).get<double>());
  const Vec3 s(size.at(0).get<double>(), size.at(2).get<double>(), size.at(1).get<double>());
  return {c - s / 2, c + s / 2};
}

std::vector<Vec2> outline_of(const Bounds& box) {
  return {{box.low.x(), box.low.y()},
          {box.high.x(), box.low.y()},
          {box.high.x(), box.high.y()},
          {box.low.x(), box.high.y()}};
}

HomeCensus ithor_home(const Json& scene, const Knowledge& knowledge) {
  CensusRoom room;
  room.type = room_type(scene.at("room"));
  std::map<std::string, std::string> type_of;
  for (const auto& object : scene.at("objects")) type_of[object.at("objectId")] = object.at("objectType");
  for (const auto& object : scene.at("objects")) {
    const std::string type = object.at("objectType");
    const bool boxed = object.contains("aabbCenter") && object.contains("aabbSize");
    if (type == "Floor" && boxed) room.outline = outline_of(box_of(object.at("aabbCenter"), object.at("aabbSize")));
    const Category* category = category_of(knowledge, type);
    if (category == nullptr) continue;
    CensusObject one{category->name, category->movable, std::nullopt, {}};
    if (boxed) one.box = box_of(object.at("aabbCenter"), object.at("aabbSize"));
    if (object.contains("parentReceptacles")) {
      for (const auto& parent : object.at("parentReceptacles")) {
        const auto holder = type_of.find(parent.get<std::string>());
        if (holder != type_of.end() && !is_structure(holder->second)) one.held_by.push_back(holder->second);
      }
    }
    room.objects.push_back(std::move(one));
  }
  return {{std::move(room)}};
}

/// Whole houses by their room types; objects are not read.
Result<std::vector<HomeCensus>> procthor_houses(const std::filesystem::path& path) {
  const auto text = read_maybe_gzip(path);
  if (!text) return text.error();
  std::vector<HomeCensus> houses;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    HomeCensus house;
    const Json json = Json::parse(line);
    for (const auto& room : json.at("rooms")) {
      house.rooms.push_back({room_type(room.at("roomType")), {}, {}});
    }
    houses.push_back(std::move(house));
  }
  return houses;
}

Result<UpstreamHomes> ai2thor_homes(const std::filesystem::path& folder, const Knowledge& knowledge) {
  UpstreamHomes all;
  const auto json = read_metadata_json(folder / "ithor_scenes.json.gz");
  if (!json) return json.error();
  all.source = "metadata:ithor_scenes.json.gz";
  for (const auto& [name, scene] : json->at("scenes").items()) all.homes.push_back(ithor_home(scene, knowledge));
  auto houses = procthor_houses(folder / "procthor_houses_other.jsonl.gz");
  if (!houses) return houses.error();
  all.room_source = "metadata:procthor_houses_other.jsonl.gz";
  all.whole = std::move(*houses);
  return all;
}

HomeCensus virtualhome_home(const Json& graph, const Knowledge& knowledge) {
  HomeCensus home;
  std::map<int, std::size_t> room_of;  // node id → position in home.rooms
  std::map<int, std::string> names;
  for (const auto& node : graph.at("nodes")) {
    const int id = node.at("id");
    names[id] = node.at("class_name");
    if (node.at("category") != "Rooms" || room_type(names[id]).empty()) continue;
    room_of[id] = home.rooms.size();
    home.rooms.push_back({room_type(names[id]), outline_of(box_of(node.at("bbox_center"), node.at("bbox_size"))), {}});
  }
  std::map<int, std::size_t> stands_in;
  std::map<int, std::vector<std::string>> held_by;
  for (const auto& edge : graph.at("edges")) {
    const int from = edge.at(0), to = edge.at(2);
    const std::string relation = edge.at(1);
    if (relation != "INSIDE" && relation != "ON") continue;
    if (const auto room = room_of.find(to); room != room_of.end()) {
      if (relation == "INSIDE") stands_in.emplace(from, room->second);
    } else if (const Category* holder = category_of(knowledge, names[to])) {
      held_by[from].push_back(holder->name);
    }
  }
  for (const auto& node : graph.at("nodes")) {
    const int id = node.at("id");
    const auto room = stands_in.find(id);
    const Category* category = category_of(knowledge, names[id]);
    if (room == stands_in.end() || category == nullptr) continue;
    home.rooms[room->second].objects.push_back(
        {category->name, category->movable, box_of(node.at("bbox_center"), node.at("bbox_size")), held_by[id]});
  }
  return home;
}

Result<UpstreamHomes> virtualhome_homes(const std::filesystem::path& folder, const Knowledge& knowledge) {
  UpstreamHomes all;
  for (int i = 1; i <= 6; ++i) {
    const auto graph = read_metadata_json(folder / "scenes" / ("TestScene" + std::to_string(i) + ".json.gz"));
    if (!graph) return graph.error();
    all.homes.push_back(virtualhome_home(*graph, knowledge));
  }
  all.source = all.room_source = "metadata:scenes/TestScene1-6.json.gz";
  all.whole = all.homes;
  return all;
}

Result<UpstreamHomes> behavior_homes(const std::filesystem::path& folder, const Knowledge& knowledge) {
  UpstreamHomes all;
  const auto json = read_metadata_json(folder / "combined_room_object_list.json.gz");
  if (!json) return json.error();
  for (const auto& [name, rooms] : json->at("scenes").items()) {
    if (!name.ends_with("_int") && !name.starts_with("house_")) continue;
    HomeCensus home;
    for (const auto& [instance, models] : rooms.items()) {
      CensusRoom room{room_type(instance.substr(0, instance.rfind('_'))), {}, {}};
      if (room.type.empty()) continue;
      for (const auto& [model, count] : models.items()) {
        const Category* category = category_of(knowledge, model.substr(0, model.rfind('-')));
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

Result<UpstreamHomes> upstream_homes(const std::filesystem::path& upstream, const Knowledge& knowledge) {
  const auto folder = upstream / std::string(name_of(knowledge.simulator()));
  try {
    switch (knowledge.simulator()) {
      case Simulator::Ai2thor:
        return ai2thor_homes(folder, knowledge);
      case Simulator::Virtualhome:
        return virtualhome_homes(folder, knowledge);
      case Simulator::Behavior:
        return behavior_homes(folder, knowledge);
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
