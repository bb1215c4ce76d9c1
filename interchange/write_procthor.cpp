#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "interchange/format_facts.h"
#include "interchange/formats.h"
#include "interchange/house_json.h"
#include "interchange/house_names.h"
#include "interchange/house_plan.h"
#include "interchange/model_choice.h"
#include "interchange/own_ids.h"
#include "interchange/unity.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kOnWall_m = 0.3;  // a window is no farther from its wall

std::string two_decimals(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", value == 0 ? 0.0 : value);
  return text;
}

class HouseWriter {
 public:
  HouseWriter(const Scene& scene, const Knowledge& knowledge, const FormatFacts& facts, const MayHold& may_hold)
      : scene_(scene),
        knowledge_(knowledge),
        facts_(facts),
        may_hold_(may_hold),
        rooms_(procthor_room_ids(scene)),
        parts_(wall_parts(scene)) {}

  ExportedScene write() {
    for (const Node& node : scene_.nodes) own_ids_.insert(node.id);
    find_holders();
    Json windows = Json::array();
    Json objects = objects_of_house(windows);
    Json gaps = doors();  // before the walls: some gaps are whole walls
    const Json house{{"rooms", rooms()},
                     {"doors", std::move(gaps)},
                     {"windows", std::move(windows)},
                     {"objects", std::move(objects)},
                     {"walls", walls()},
                     {"proceduralParameters", house_parameters(scene_)},
                     {"metadata", house_metadata(scene_)}};
    return {house.dump(1, ' ', false, Json::error_handler_t::replace) + "\n", std::move(left_out_), std::move(names_),
            std::move(models_)};
  }

 private:
  std::string wall_id(const WallPart& part, bool exterior) const {
    const Vec2 low = part.from.cwiseMin(part.to), high = part.from.cwiseMax(part.to);
    return "wall|" + (exterior ? std::string("exterior") : number_of(part.room)) + "|" + two_decimals(low.x()) + "|" +
           two_decimals(low.y()) + "|" + two_decimals(high.x()) + "|" + two_decimals(high.y());
  }

  /// "2" of "room|2": what the ids of walls, doors and objects say of their room.
  std::string number_of(std::size_t room) const { return rooms_[room].substr(rooms_[room].rfind('|') + 1); }

  Json rooms() const {
    Json all = Json::array();
    for (std::size_t r = 0; r < scene_.rooms.size(); ++r) {
      const std::string type = room_type_to_procthor(scene_.rooms[r].type);
      // Floors and walls run clockwise in Unity's x, z: so their lit sides look up and inwards.
      Json polygon = Json::array();
      for (auto corner = scene_.rooms[r].polygon.rbegin(); corner != scene_.rooms[r].polygon.rend(); ++corner) {
        polygon.push_back(house_point(*corner));
      }
      all.push_back({{"id", rooms_[r]},
                     {"roomType", type},
                     {"children", Json::array()},
                     {"ceilings", Json::array()},
                     {"floorPolygon", std::move(polygon)},
                     {"floorMaterial", house_material(facts_.floor_materials.find(type)->second)},
                     {"layer", house_layer(r)}});
    }
    return all;
  }

  Json walls() const {
    Json all = Json::array();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const WallPart& part = parts_[i];
      const double h = scene_.wall_height;
      Json inner{{"id", wall_id(part, false)},
                 {"roomId", rooms_[part.room]},
                 {"polygon",
                  {house_point(part.to), house_point(part.from), house_point(part.to, h), house_point(part.from, h)}}};
      if (std::find(missing_.begin(), missing_.end(), i) != missing_.end()) inner["empty"] = true;
      inner["material"] = house_paint(0.7961, 0.8196, 0.7294);
      inner["layer"] = house_layer(part.room);
      all.push_back(std::move(inner));
      if (part.behind) continue;
      all.push_back(
          {{"id", wall_id(part, true)},
           {"roomId", rooms_[part.room]},
           {"polygon",
            {house_point(part.to, h), house_point(part.from, h), house_point(part.to), house_point(part.from)}},
           {"material", house_material("RedBricks 1")},
           {"layer", house_layer(part.room)}});
    }
    return all;
  }

  Json doors() {
    Json all = Json::array();
    for (const Opening& opening : scene_.openings) {
      const auto a = index_of(opening.room_a), b = index_of(opening.room_b);
      const Vec2 middle = (opening.from + opening.to) / 2;
      const auto wall = a && b ? nearest_wall(parts_, middle, kOnWall_m, a, b) : std::nullopt;
      const auto far_side = wall ? nearest_wall(parts_, middle, kOnWall_m, b, a) : std::nullopt;
      if (!wall || !far_side) {
        left_out_.push_back(opening.id + ": it lies on no wall that its rooms share");
        continue;
      }
      const WallPart& part = parts_[wall->part];
      const double length = (part.to - part.from).norm(), width = (opening.to - opening.from).norm();
      if (width > length - 0.02 && opening.height > scene_.wall_height - 0.02) {
        missing_.push_back(wall->part);
        missing_.push_back(far_side->part);
        continue;
      }
      const DoorModel& model = door_model_for(width, facts_);
      if (std::abs(model.width - width) > 0.15) {
        left_out_.push_back(opening.id + ": no frame is " + number_text(house_number(width, 100)) + " m wide; " +
                            model.name + " is used");
      }
      const double along = length - wall->along;  // theirs is counted from our `to`
      const std::size_t low = std::min(*a, *b), high = std::max(*a, *b);
      Json id = "door|" + number_of(low) + "|" + number_of(high);
      const int same = ++door_ids_[id.get<std::string>()];
      if (same > 1) id = id.get<std::string>() + "|" + std::to_string(same);
      all.push_back(
          {{"id", std::move(id)},
           {"room0", rooms_[*a]},
           {"room1", rooms_[*b]},
           {"wall0", wall_id(part, false)},
           {"wall1", wall_id(parts_[far_side->part], false)},
           {"assetId", model.name},
           {"assetPosition", house_xyz({along, model.height / 2, 0})},
           {"holePolygon", {house_xyz({along - width / 2, 0, 0}), house_xyz({along + width / 2, opening.height, 0})}},
           {"openable", false},
           {"openness", 1}});
    }
    return all;
  }

  std::optional<std::size_t> index_of(const std::string& room) const {
    const Room* found = find_room(scene_, room);
    return found == nullptr ? std::nullopt : std::optional<std::size_t>(found - scene_.rooms.data());
  }

  // Objects.

  /// Of each node the one thing that it stands on or lies in: with several, the last that holds no other of them.
  void find_holders() {
    std::map<std::string, std::size_t> node_of;
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) node_of[scene_.nodes[i].id] = i;
    std::vector<std::vector<std::size_t>> all(scene_.nodes.size());
    for (const Edge& edge : scene_.edges) {
      if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
      const auto from = node_of.find(edge.from), to = node_of.find(edge.to);
      if (from != node_of.end() && to != node_of.end()) all[from->second].push_back(to->second);
    }
    const auto volume = [&](std::size_t i) { return scene_.nodes[i].size.prod(); };
    holder_.resize(scene_.nodes.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::erase_if(all[i], [&](std::size_t holder) { return volume(holder) <= volume(i); });  // so no way is a circle
      if (all[i].empty()) continue;
      holder_[i] = *std::min_element(all[i].begin(), all[i].end(),
                                     [&](std::size_t a, std::size_t b) { return volume(a) < volume(b); });
    }
  }

  Json objects_of_house(Json& windows) {
    std::vector<std::optional<Json>> made(scene_.nodes.size());
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      order.push_back(i);
      made[i] = object(i, windows);
    }
    // What is held first, so that every holder is complete when it goes into its own; the smaller is held.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return scene_.nodes[a].size.prod() < scene_.nodes[b].size.prod();
    });
    std::vector<bool> inside(scene_.nodes.size(), false);
    std::vector<std::vector<std::size_t>> held(scene_.nodes.size());
    for (const std::size_t i : order) {
      if (!made[i]) continue;
      auto holder = holder_[i];
      while (holder && !(made[*holder] && can_hold(scene_.nodes[*holder]))) holder = holder_[*holder];
      if (!holder) continue;
      inside[i] = true;
      if (const std::string why = misplaced(i, *holder); !why.empty()) {
        leave_out(i, held, why);
        continue;
      }
      (*made[*holder])["children"].push_back(*made[i]);
      held[*holder].push_back(i);
    }
    Json objects = Json::array();
    for (std::size_t i = 0; i < made.size(); ++i) {
      if (made[i] && !inside[i]) objects.push_back(std::move(*made[i]));
    }
    return objects;
  }

  /// Why a thing may not be on or in another; "" where it may.
  std::string misplaced(std::size_t thing, std::size_t holder) const {
    const Node &one = scene_.nodes[thing], &place = scene_.nodes[holder];
    if (!may_hold_ || own_id_of(one, Simulator::Ai2thor) || may_hold_(one.category, place.category)) return "";
    return "no table of AI2-THOR's has " + one.category + " on or in " + place.category;
  }

  /// Takes out an object, and all that it holds. What is not there has no name.
  void leave_out(std::size_t i, const std::vector<std::vector<std::size_t>>& held, const std::string& why) {
    left_out_.push_back(scene_.nodes[i].id + ": " + why);
    names_.erase(scene_.nodes[i].id);
    models_.erase(scene_.nodes[i].id);
    for (const std::size_t one : held[i]) leave_out(one, held, why);
  }

  /// Whether things can be on or in an object of the house there: a plant that something lies on is no receptacle, and
  /// what heats takes what it heats.
  bool can_hold(const Node& node) const {
    constexpr std::array kHolding{"receptacle", "container", "heat_source"};
    return std::any_of(kHolding.begin(), kHolding.end(),
                       [&](const char* one) { return knowledge_.has(node.category, one); });
  }

  /// What folds as a box around it, opened as far as it is.
  static Node as_it_stands(Node node) {
    if (node.archetype != Archetype::Folding || node.opening <= 0) return node;
    const Bounds open = bounds_of(shape_of(node), Pose(), node.opening);
    node.pose = node.pose * Pose{(open.low + open.high) / 2, Quat::Identity()};
    node.size = open.high - open.low;
    return node;
  }

  std::optional<Json> object(std::size_t i, Json& windows) {
    Node node = as_it_stands(scene_.nodes[i]);
    std::string why;
    ChosenModel chosen = model_for(node, knowledge_, facts_, why);
    const bool lid_closed = node.archetype == Archetype::Folding && node.opening <= 0;
    if (chosen.asset == nullptr && lid_closed) {  // most models of what folds are measured with their lids up
      node.opening = 1;
      node = as_it_stands(std::move(node));
      chosen = model_for(node, knowledge_, facts_, why);
    }
    const Asset* const model = chosen.asset;
    if (model == nullptr) {
      left_out_.push_back(node.id + ": " + why);
      return std::nullopt;
    }
    if (node.category == "Window") {
      add_window(node, *model, windows);
      return std::nullopt;
    }
    const Room* room = room_at(scene_, node.pose.position.head<2>());
    if (room == nullptr) {
      left_out_.push_back(node.id + ": it is in no room");
      return std::nullopt;
    }
    const auto in = static_cast<std::size_t>(room - scene_.rooms.data());
    // The model stands where the node does: on the same lowest level.
    Pose pose = node.pose;
    pose.rotation = pose.rotation * chosen.turn;
    pose.position.z() += bounds_of(Pose{Vec3::Zero(), pose.rotation}, model->size).high.z() -
                         bounds_of(Pose{Vec3::Zero(), node.pose.rotation}, node.size).high.z();
    Json json{{"id", id_of(node, in)},
              {"position", house_xyz(to_unity(pose.position))},
              {"rotation", house_xyz(rotation_to_unity(pose.rotation), 1000)},
              {"assetId", model->name},
              {"objectType", node.category},
              {"kinematic", !node.movable},
              {"layer", house_layer(in)}};
    names_[node.id] = json["id"];
    models_[node.id] = model->name;
    if (node.states.has(Predicate::Open)) {
      json["openness"] = node.opening > 0 ? house_number(node.opening, 1000) : 1.0;
    } else if (lid_closed) {
      json["openness"] = 0.0;
    }
    if (node.states.has(Predicate::Dirty)) json["isDirty"] = true;
    if (node.states.has(Predicate::PowerOn)) json["isOn"] = true;
    return json;
  }

  /// The id that the object has in a house of ProcTHOR; for others a new one, as ProcTHOR makes them.
  std::string id_of(const Node& node, std::size_t room) {
    if (auto own = own_id_of(node, Simulator::Ai2thor)) return *own;
    const std::string stem = node.category + "|" + number_of(room) + "|";
    std::string id;
    do id = stem + std::to_string(numbers_[room]++);
    while (own_ids_.contains(id));
    return id;
  }

  void add_window(const Node& node, const Asset& model, Json& windows) {
    const auto wall = nearest_wall(parts_, node.pose.position.head<2>(), kOnWall_m);
    if (!wall || parts_[wall->part].behind) {
      left_out_.push_back(node.id + ": it is in no outer wall");
      return;
    }
    const WallPart& part = parts_[wall->part];
    const double along = (part.to - part.from).norm() - wall->along, up = node.pose.position.z();
    const Vec3 half = model.size / 2;
    windows.push_back(
        {{"id", "window|" + number_of(part.room) + "|" + std::to_string(windows.size())},
         {"assetId", model.name},
         {"room0", rooms_[part.room]},
         {"room1", rooms_[part.room]},
         {"wall0", wall_id(part, false)},
         {"wall1", wall_id(part, true)},
         {"holePolygon",
          {house_xyz({along - half.x(), up - half.z(), 0}), house_xyz({along + half.x(), up + half.z(), 0})}},
         {"assetPosition", house_xyz({along, up, 0})}});
  }

  const Scene& scene_;
  const Knowledge& knowledge_;
  const FormatFacts& facts_;
  const MayHold& may_hold_;
  std::vector<std::string> rooms_;  // the house's ids
  std::vector<WallPart> parts_;
  std::vector<std::size_t> missing_;                // parts of walls that are not there
  std::vector<std::optional<std::size_t>> holder_;  // of each node
  std::set<std::string, std::less<>> own_ids_;      // of all nodes, some of which are AI2-THOR's own
  std::map<std::size_t, int> numbers_;              // objects of each room so far
  std::map<std::string, int> door_ids_;
  std::vector<std::string> left_out_;
  std::map<std::string, std::string> names_, models_;
};

}  // namespace

std::vector<std::string> procthor_room_ids(const Scene& scene) {
  std::vector<std::string> ids;
  std::set<std::string, std::less<>> taken;
  for (const Room& room : scene.rooms) {
    std::string own = own_id_of(room, Simulator::Ai2thor).value_or("");
    if (!own.empty() && !taken.insert(own).second) own.clear();  // an edited scene may say one number twice
    ids.push_back(std::move(own));
  }
  int number = 2;  // theirs begin with 2
  for (std::string& id : ids) {
    while (id.empty()) {
      std::string next = "room|" + std::to_string(number++);
      if (!taken.contains(next)) id = std::move(next);
    }
  }
  return ids;
}

Result<ExportedScene> write_procthor(const Scene& scene, const Knowledge& knowledge, const FormatFacts& facts,
                                     const MayHold& may_hold) {
  const auto refuse = [&](std::string message) { return Error{Error::Kind::Usage, scene.id, {}, std::move(message)}; };
  if (scene.simulator != Simulator::Ai2thor || knowledge.simulator() != Simulator::Ai2thor) {
    return refuse("ProcTHOR houses contain AI2-THOR's objects; this scene belongs to " +
                  std::string(name_of(scene.simulator)));
  }
  if (scene.rooms.empty()) return refuse("a house needs a room");
  return HouseWriter(scene, knowledge, facts, may_hold).write();
}

}  // namespace unietp
