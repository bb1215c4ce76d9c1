#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "interchange/floor_tiles.h"
#include "interchange/formats.h"
#include "interchange/own_ids.h"
#include "interchange/virtualhome_frame.h"
#include "interchange/virtualhome_prefab.h"
#include "interchange/virtualhome_words.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kClose_m = 1.5;       // CLOSE: the largest gap between two boxes, as measured in upstream's homes
constexpr double kFacing_m = 5;        // FACING: the largest distance of the middles, as measured there
constexpr double kFacingCosine = 0.5;  // and within 60° of where the seen thing's front looks; curated
constexpr double kFrame_m = 0.1223;    // thickness of upstream's door frames

Json json_of(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

class Exporter {
 public:
  Exporter(const Scene& scene, const Knowledge& knowledge, const FormatFacts& facts)
      : scene_(scene), knowledge_(knowledge), facts_(facts) {}

  ExportedScene write() {
    add_nodes();
    for (const Edge& edge : scene_.edges) add_edge(edge);
    add_held();
    add_close();
    add_facing();
    return {text(), std::move(left_out_), std::move(names_)};
  }

  std::map<std::string, std::string> names() {
    add_nodes();
    return std::move(names_);
  }

 private:
  void add_nodes() {
    for (const Node& node : scene_.nodes) {
      if (const int number = own_number(node); number > 0) own_numbers_.insert(number);
    }
    for (const Room& room : scene_.rooms) {
      if (const int number = own_number(room); number > 0) own_numbers_.insert(number);
    }
    for (const Room& room : scene_.rooms) add_room(room);
    for (const Room& room : scene_.rooms) add_floor(room);
    for (const Opening& opening : scene_.openings) add_doorway(opening);
    add_agent();
    for (const Node& node : scene_.nodes) add_object(node);
  }

  struct Placed {
    int id = 0;
    Bounds bounds;
    const Node* node = nullptr;
    const Room* room = nullptr;
  };

  /// The number of an object or room in the graph that the home was imported from; 0 for what was not.
  template <class Thing>
  static int own_number(const Thing& thing) {
    const auto own = own_id_of(thing, Simulator::Virtualhome);
    return own ? std::stoi(*own) : 0;
  }

  int fresh_number() {
    do ++last_number_;
    while (own_numbers_.contains(last_number_));
    return last_number_;
  }

  /// `id`: the node's number; 0 for a new one.
  int add(const std::string& class_name, const std::string& group, const std::string& prefab, const Bounds& bounds,
          int id = 0) {
    if (id == 0) id = fresh_number();
    const Vec3 center = (bounds.low + bounds.high) / 2, extents = bounds.high - bounds.low;
    nodes_.push_back({{"id", id},
                      {"class_name", class_name},
                      {"category", group},
                      {"prefab_name", prefab},
                      {"properties", Json::array()},
                      {"states", Json::array()},
                      {"bounding_box", {{"center", json_of(to_unity(center))}, {"size", json_of(to_unity(extents))}}}});
    return id;
  }

  void edge(int from, const char* relation, int to) {
    edges_.push_back({{"from_id", from}, {"to_id", to}, {"relation_type", relation}});
  }

  void transform(const Bounds& bounds, const Quat& rotation, const Vec3& scale_in_unity) {
    const Vec3 foot((bounds.low.x() + bounds.high.x()) / 2, (bounds.low.y() + bounds.high.y()) / 2, bounds.low.z());
    nodes_.back()["obj_transform"] = {{"position", json_of(to_unity(foot))},
                                      {"rotation", {rotation.x(), rotation.y(), rotation.z(), rotation.w()}},
                                      {"scale", json_of(scale_in_unity)}};
  }

  void add_room(const Room& room) {
    Bounds bounds{Vec3(1e9, 1e9, 0), Vec3(-1e9, -1e9, scene_.wall_height)};
    for (const Vec2& corner : room.polygon) {
      bounds.low.head<2>() = bounds.low.head<2>().cwiseMin(corner);
      bounds.high.head<2>() = bounds.high.head<2>().cwiseMax(corner);
    }
    ids_[room.id] = add(virtualhome_room_name(room.type, facts_), "Rooms", "", bounds, own_number(room));
  }

  void add_floor(const Room& room) {
    std::vector<Tile> tiles = tiles_of(room.polygon);
    if (tiles.empty()) {
      left_out_.push_back(room.id + ": its walls are not along the axes, its floor is the box around it");
      Tile whole{room.polygon.front(), room.polygon.front()};
      for (const Vec2& corner : room.polygon) {
        whole.low = whole.low.cwiseMin(corner), whole.high = whole.high.cwiseMax(corner);
      }
      tiles.push_back(whole);
    }
    for (const Tile& tile : tiles) {
      const Bounds bounds{Vec3(tile.low.x(), tile.low.y(), 0), Vec3(tile.high.x(), tile.high.y(), 0)};
      const int id = add("floor", "Floor", "", bounds);
      edge(id, "INSIDE", ids_.at(room.id));
      floors_.push_back({id, bounds, nullptr, &room});
    }
  }

  void add_doorway(const Opening& opening) {
    const Vec2 along = opening.to - opening.from;
    if (!(along.norm() > 0)) {
      left_out_.push_back(opening.id + ": it has no width");
      return;
    }
    const Vec2 across = Vec2(std::abs(along.y()), std::abs(along.x())) * (kFrame_m / 2 / along.norm());
    const Vec2 low = opening.from.cwiseMin(opening.to) - across, high = opening.from.cwiseMax(opening.to) + across;
    const int id = add("doorjamb", "Doors", "", {Vec3(low.x(), low.y(), 0), Vec3(high.x(), high.y(), opening.height)});
    for (const std::string& room : {opening.room_a, opening.room_b}) {
      if (const auto at = ids_.find(room); at != ids_.end()) edge(id, "BETWEEN", at->second);
    }
  }

  void add_agent() {
    const Vec2 half(0.25, 0.25);
    const Vec2 low = scene_.agent.position - half, high = scene_.agent.position + half;
    const Bounds bounds{Vec3(low.x(), low.y(), 0), Vec3(high.x(), high.y(), 1.67)};
    agent_ = add("character", "Characters", "Male1", bounds);
    const double turn = scene_.agent.yaw - std::numbers::pi / 2;
    transform(bounds, turn_from_unity(upright(Vec3::Zero(), turn).rotation), Vec3::Ones());
    if (const Room* room = room_at(scene_, scene_.agent.position)) edge(agent_, "INSIDE", ids_.at(room->id));
  }

  void add_object(const Node& node) {
    const Category* category = knowledge_.find(node.category);
    if (category == nullptr) {
      left_out_.push_back(node.id + ": VirtualHome has no class \"" + node.category + "\"");
      return;
    }
    const Bounds bounds = bounds_of(node.pose, node.size);
    const auto [prefab, its_size] = virtualhome_prefab(node, knowledge_, facts_);
    const int id = add(node.category, virtualhome_group(*category, knowledge_), prefab, bounds, own_number(node));
    const Vec3 scale = node.size.cwiseQuotient(its_size.isZero() ? category->size : its_size);
    transform(bounds, object_rotation_to_unity(node.pose.rotation, prefab), scale_to_unity(scale, prefab));
    Json& json = nodes_.back();
    for (const auto& [property, affordance] : facts_.virtualhome_properties) {
      if (knowledge_.has(node.category, affordance)) json["properties"].push_back(property);
    }
    add_states(node, json["states"]);
    ids_[node.id] = id;
    names_[node.id] = node.category + "_" + std::to_string(id);  // as scene graphs of VirtualHome name their nodes
    placed_.push_back({id, bounds, &node, room_at(scene_, node.pose.position.head<2>())});
  }

  void add_states(const Node& node, Json& states) {
    for (const State& state : node.states.all()) {
      if (const auto word = virtualhome_state(state.predicate, facts_); !word.empty()) {
        states.push_back(word);
      } else if (!is_default(state.predicate)) {
        left_out_.push_back(node.id + ": VirtualHome has no word for " + std::string(info(state.predicate).name));
      }
    }
    if (node.opening > 0 && node.opening < 1) left_out_.push_back(node.id + ": how far it is open");
  }

  static bool is_default(Predicate predicate) {
    const auto& groups = state_groups();
    return std::any_of(groups.begin(), groups.end(),
                       [&](const StateGroup& group) { return group.predicates.front() == predicate; });
  }

  void add_edge(const Edge& e) {
    const auto from = ids_.find(e.from), to = ids_.find(e.to);
    if (from == ids_.end() || to == ids_.end()) return;
    if (e.relation == Predicate::On) edge(from->second, "ON", to->second);
    if (e.relation == Predicate::Inside || e.relation == Predicate::InRoom) edge(from->second, "INSIDE", to->second);
    if (e.relation == Predicate::OnFloor) {
      const Node* node = find_node(scene_, e.from);
      if (node == nullptr) return;
      const Vec2 point = node->pose.position.head<2>();
      for (const Placed& floor : floors_) {
        const Vec2 low = floor.bounds.low.head<2>(), high = floor.bounds.high.head<2>();
        if ((point - low).minCoeff() < 0 || (high - point).minCoeff() < 0) continue;
        return edge(from->second, "ON", floor.id);
      }
    }
  }

  void add_held() {
    for (std::size_t hand = 0; hand < scene_.agent.held.size(); ++hand) {
      const auto at = ids_.find(scene_.agent.held[hand]);
      if (at != ids_.end()) edge(agent_, hand == 0 ? "HOLDS_RH" : "HOLDS_LH", at->second);
    }
  }

  void add_close() {
    constexpr std::size_t kMostCrowded = 2000;  // the edges grow with the square
    if (placed_.size() > kMostCrowded) {
      left_out_.push_back("CLOSE edges, since there are more than 2000 objects");
      return;
    }
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      for (std::size_t j = i + 1; j < placed_.size(); ++j) {
        const Bounds &a = placed_[i].bounds, &b = placed_[j].bounds;
        const Vec3 gap = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Vec3::Zero());
        if (gap.norm() > kClose_m) continue;
        edge(placed_[i].id, "CLOSE", placed_[j].id);
        edge(placed_[j].id, "CLOSE", placed_[i].id);
      }
    }
  }

  /// As upstream: from what stands in view of a screen, a picture or a clock in the same room.
  void add_facing() {
    for (const Placed& seen : placed_) {
      if (!facts_.virtualhome_faced.contains(seen.node->category)) continue;
      const Vec3 front = seen.node->pose.rotation * -Vec3::UnitY();
      for (const Placed& from : placed_) {
        const Vec3 way = from.node->pose.position - seen.node->pose.position;
        if (from.id == seen.id || from.room != seen.room || way.norm() > kFacing_m) continue;
        if (way.dot(front) > kFacingCosine * way.norm()) edge(from.id, "FACING", seen.id);
      }
    }
  }

  /// One node or edge a line.
  std::string text() const {
    const auto lines = [](const std::vector<Json>& items) {
      std::string list = "[";
      const char* separator = "\n";
      for (const Json& item : items) {
        list += separator + item.dump(-1, ' ', false, Json::error_handler_t::replace);
        separator = ",\n";
      }
      return list + "\n]";
    };
    return "{\n\"nodes\": " + lines(nodes_) + ",\n\"edges\": " + lines(edges_) + "\n}\n";
  }

  const Scene& scene_;
  const Knowledge& knowledge_;
  const FormatFacts& facts_;
  std::vector<Json> nodes_, edges_;
  std::map<std::string, int, std::less<>> ids_;  // of rooms and nodes
  std::vector<Placed> floors_, placed_;
  std::set<int> own_numbers_;  // of nodes, in the graph that the home was imported from
  int last_number_ = 0;
  int agent_ = 0;
  std::vector<std::string> left_out_;
  std::map<std::string, std::string> names_;
};

}  // namespace

std::map<std::string, std::string> virtualhome_names(const Scene& scene, const Knowledge& knowledge,
                                                     const FormatFacts& facts) {
  return Exporter(scene, knowledge, facts).names();
}

Result<ExportedScene> write_virtualhome(const Scene& scene, const Knowledge& knowledge, const FormatFacts& facts) {
  if (scene.simulator != Simulator::Virtualhome || knowledge.simulator() != Simulator::Virtualhome) {
    return Error{Error::Kind::Schema,
                 scene.id,
                 {},
                 "expected a scene of virtualhome, not of " + std::string(name_of(scene.simulator))};
  }
  return Exporter(scene, knowledge, facts).write();
}

}  // namespace unietp
