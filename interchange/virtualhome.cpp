#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/text.h"
#include "interchange/box_facing.h"
#include "interchange/floor_tiles.h"
#include "interchange/foreign_json.h"
#include "interchange/formats.h"
#include "interchange/own_ids.h"
#include "interchange/virtualhome_frame.h"
#include "interchange/virtualhome_graph.h"
#include "interchange/virtualhome_prefab.h"
#include "interchange/virtualhome_words.h"

namespace unietp {
namespace {

using NodeAt = std::map<long long, const VirtualhomeNode*>;

bool is_room(const VirtualhomeNode& node) { return node.category == "Rooms"; }
bool is_doorway(const VirtualhomeNode& node) { return node.category == "Doors"; }
bool is_agent(const VirtualhomeNode& node) { return node.category == "Characters" || node.class_name == "character"; }
bool is_floor(const VirtualhomeNode& node) { return lower(node.class_name) == "floor"; }

Tile footprint(const VirtualhomeNode& node) {
  const Vec3 center = from_unity(node.center), half = from_unity(node.extents) / 2;
  return {(center - half).head<2>(), (center + half).head<2>()};
}

/// What the models' and categories' sizes say of a node: its extents in the object frame, zero when not known.
struct Typical {
  Vec3 model = Vec3::Zero(), category = Vec3::Zero();
  bool stands_at_walls = false;
};

class Importer {
 public:
  Importer(const VirtualhomeGraph& graph, const Knowledge& knowledge, const FormatFacts& facts)
      : graph_(graph), knowledge_(knowledge), facts_(facts) {
    for (const VirtualhomeNode& node : graph.nodes) {
      nodes_[node.id] = &node;
      if (is_doorway(node) && node.has_box) doorways_.push_back(&node);
    }
  }

  SourceScene scene(std::string id) {
    scene_.id = std::move(id);
    scene_.simulator = Simulator::Virtualhome;
    read_edges();
    add_rooms();
    add_openings();
    for (const VirtualhomeNode& node : graph_.nodes) add_node(node);
    warn_of_counts();
    return std::move(scene_);
  }

 private:
  const VirtualhomeNode* node(long long id) const {
    const auto found = nodes_.find(id);
    return found == nodes_.end() ? nullptr : found->second;
  }

  void read_edges() {
    for (const VirtualhomeEdge& edge : graph_.edges) {
      const VirtualhomeNode *from = node(edge.from), *to = node(edge.to);
      if (from == nullptr || to == nullptr) {
        ++counts_["edges refer to a node that is not in the graph"];
      } else if (edge.relation == "BETWEEN" && is_room(*to)) {
        between_[edge.from].push_back(edge.to);
      } else if (edge.relation == "INSIDE" && is_room(*to)) {
        room_of_[edge.from] = edge.to;
      } else if (edge.relation == "INSIDE" || edge.relation == "ON") {
        held_by_[edge.from].push_back({kind_of(edge.relation == "ON", *from, *to), std::to_string(edge.to)});
      } else if (edge.relation.starts_with("HOLDS") && is_agent(*from)) {
        scene_.agent.held.push_back(std::to_string(edge.to));
      }
    }
  }

  /// VirtualHome reads its relations from boxes: INSIDE is within the other's box, on an open shelf too, and ON is over
  /// its middle, in a bowl too. Ours tell a hollow from a surface.
  SourceRelation::Kind kind_of(bool on, const VirtualhomeNode& object, const VirtualhomeNode& receptacle) const {
    constexpr double kSunk_m = 0.01;
    const Category* category = category_of(receptacle);
    const bool hollow =
        category != nullptr && (category->archetype == Archetype::Cabinet || category->archetype == Archetype::Vessel ||
                                category->archetype == Archetype::Lidded);
    if (!on) return hollow ? SourceRelation::Kind::Inside : SourceRelation::Kind::OnOrInside;
    const double low = object.center.y() - object.extents.y() / 2;
    const double high = receptacle.center.y() + receptacle.extents.y() / 2;
    return low < high - kSunk_m ? SourceRelation::Kind::OnOrInside : SourceRelation::Kind::On;
  }

  const Category* category_of(const VirtualhomeNode& node) const {
    const Category* category = knowledge_.find(node.class_name);
    return category != nullptr ? category : knowledge_.find(replace_all(lower(node.class_name), "_", ""));
  }

  void add_rooms() {
    std::map<long long, std::vector<Tile>> floors;  // of rooms
    for (const VirtualhomeNode& tile : graph_.nodes) {
      const auto room = room_of_.find(tile.id);
      if (room == room_of_.end() || !is_floor(tile) || !tile.has_box) continue;
      const Tile print = footprint(tile);
      if ((print.high - print.low).minCoeff() > 0) floors[room->second].push_back(print);
    }
    std::vector<const VirtualhomeNode*> rooms;
    std::vector<std::vector<Tile>> tiles;
    for (const VirtualhomeNode& room : graph_.nodes) {
      if (!is_room(room) || !room.has_box) continue;
      auto& floor = floors[room.id];
      if (floor.empty()) floor.push_back(footprint(room));
      rooms.push_back(&room);
      tiles.push_back(std::move(floor));
      scene_.wall_height = rooms.size() == 1 ? room.extents.y() : std::max(scene_.wall_height, room.extents.y());
    }
    constexpr double kSameWall_m = 0.06;  // neighbors' tiles miss each other by up to 3 cm
    std::vector<Tile*> all;
    for (auto& floor : tiles) {
      for (Tile& tile : floor) all.push_back(&tile);
    }
    align(all, kSameWall_m);
    std::map<std::string, int> count;
    for (std::size_t i = 0; i < rooms.size(); ++i) {
      const std::string type = room_type_of_virtualhome(rooms[i]->class_name, facts_);
      const auto outline = outline_of(tiles[i]);
      const std::string number = std::to_string(++count[type]);
      std::string id = simulators_room_id(type, std::to_string(rooms[i]->id), Simulator::Virtualhome);
      if (id.empty() || room_index_.contains(rooms[i]->id)) id = type + "_" + number;
      scene_.rooms.push_back({std::move(id), type, outline ? *outline : corners_of(bounds_of(tiles[i]))});
      room_index_[rooms[i]->id] = i;
    }
  }

  /// A doorway's leaf and frame are one opening: what says which rooms it joins counts, the frame says how high it is.
  void add_openings() {
    for (const VirtualhomeNode& door : graph_.nodes) {
      if (!is_doorway(door)) continue;
      std::vector<std::size_t> rooms;
      for (const long long room : between_[door.id]) {
        if (const auto found = room_index_.find(room); found != room_index_.end()) rooms.push_back(found->second);
      }
      if (!door.has_box || rooms.size() != 2) {
        ++counts_["doors and frames join no two rooms of the graph"];
        continue;
      }
      Opening opening = opening_in(scene_.rooms[rooms[0]].polygon, footprint(door));
      opening.id = "opening_" + std::to_string(scene_.openings.size() + 1);
      opening.room_a = scene_.rooms[rooms[0]].id;
      opening.room_b = scene_.rooms[rooms[1]].id;
      opening.height = height_of_frame(door);
      scene_.openings.push_back(std::move(opening));
    }
  }

  double height_of_frame(const VirtualhomeNode& door) const {
    constexpr double kSamePlace_m = 0.3;
    double top = door.center.y() + door.extents.y() / 2;
    for (const VirtualhomeNode* other : doorways_) {
      const Vec3 apart = from_unity(other->center) - from_unity(door.center);
      if (apart.head<2>().norm() < kSamePlace_m) top = std::max(top, other->center.y() + other->extents.y() / 2);
    }
    return std::max(1.0, std::min(top, scene_.wall_height));
  }

  /// Floors, walls and doors are objects of the file too.
  void add_node(const VirtualhomeNode& node) {
    if (is_room(node)) return;
    if (!is_agent(node)) return add_object(node);
    if (node.has_box) add_agent(node);
  }

  void add_agent(const VirtualhomeNode& node) {
    if (scene_.has_agent) {
      ++counts_["further characters"];
      return;
    }
    scene_.has_agent = true;
    scene_.agent.position = from_unity(node.center).head<2>();
    const Vec3 forward = turn_from_unity(node.rotation) * Vec3::UnitY();
    scene_.agent.yaw = std::atan2(forward.y(), forward.x());
  }

  Typical typical_of(const VirtualhomeNode& node) const {
    Typical typical;
    const Asset* model = knowledge_.asset(node.prefab);
    const Category* category = category_of(node);
    if (model != nullptr) typical.model = model->size;
    if (category != nullptr) {
      typical.category = category->size;
      typical.stands_at_walls = !category->movable;
    }
    return typical;
  }

  void add_object(const VirtualhomeNode& node) {
    SourceObject object;
    object.id = std::to_string(node.id);
    object.category = node.class_name;
    object.asset = node.prefab;
    object.held_by = held_by_[node.id];
    if (const auto room = room_of_.find(node.id); room != room_of_.end()) {
      if (const auto at = room_index_.find(room->second); at != room_index_.end()) {
        object.room = scene_.rooms[at->second].id;
      }
    }
    for (const std::string& name : node.states) {
      const auto state = state_of_virtualhome(name, facts_);
      if (!state) {
        ++counts_["states that a scene cannot represent (" + name.substr(0, 30) + ")"];
        continue;
      }
      object.states.push_back(*state);
      if (state->predicate == Predicate::Open) object.opening = 1;
    }
    if (node.has_box) place(node, object);
    scene_.objects.push_back(std::move(object));
  }

  void place(const VirtualhomeNode& node, SourceObject& object) {
    const Vec3 extents = from_unity(node.extents);
    Typical typical = typical_of(node);
    object.pose.position = from_unity(node.center);
    if (node.has_transform) {
      if (const auto size = size_of_prefab(node.prefab, node.class_name, knowledge_, facts_)) typical.model = *size;
      object.pose.rotation = object_rotation_from_unity(node.rotation, node.prefab);
      if (const auto size =
              turned_size(extents, object.pose.rotation, typical, scale_from_unity(node.scale, node.prefab))) {
        object.size = *size;
        return;
      }
      ++counts_["boxes do not fit their rotation: treated as axis-aligned"];
    }
    const auto room = room_of_.find(node.id);
    const auto at = room == room_of_.end() ? room_index_.end() : room_index_.find(room->second);
    const Facing facing = facing_of_box(
        object.pose.position, extents, typical.model.isZero() ? typical.category : typical.model,
        typical.stands_at_walls, at == room_index_.end() ? std::vector<Vec2>() : scene_.rooms[at->second].polygon);
    object.pose = upright(object.pose.position, facing.yaw);
    object.size = facing.size;
  }

  /// The size of a turned box from its bounds: the model's or category's where that fits them, else what they tell.
  static std::optional<Vec3> turned_size(const Vec3& extents, const Quat& rotation, const Typical& typical,
                                         const Vec3& scale_of_sides) {
    constexpr double kFits_m = 0.005;
    const Eigen::Matrix3d reach = rotation.toRotationMatrix().cwiseAbs();
    for (const Vec3& known : {typical.model, typical.category}) {
      const Vec3 size = known.cwiseProduct(scale_of_sides);
      if (size.minCoeff() > 0 && ((reach * size - extents).cwiseAbs().maxCoeff() < kFits_m)) return size;
    }
    return size_from_bounds(extents, rotation);
  }

  void warn_of_counts() {
    for (const auto& [what, count] : counts_) scene_.warnings.push_back(std::to_string(count) + " " + what);
  }

  const VirtualhomeGraph& graph_;
  const Knowledge& knowledge_;
  const FormatFacts& facts_;
  NodeAt nodes_;
  std::vector<const VirtualhomeNode*> doorways_;
  std::map<long long, long long> room_of_;
  std::map<long long, std::vector<long long>> between_;
  std::map<long long, std::vector<SourceRelation>> held_by_;
  std::map<long long, std::size_t> room_index_;
  std::map<std::string, int> counts_;
  SourceScene scene_;
};

}  // namespace

Result<std::vector<SourceScene>> read_virtualhome(const std::string& where, std::string_view text,
                                                  const Knowledge& knowledge, const FormatFacts& facts) {
  return read_homes(where, text, {"nodes"}, [&](JsonReader& reader, const JsonAt& home, std::string id) {
    const VirtualhomeGraph graph = read_virtualhome_graph(reader, home);
    if (reader.error()) return SourceScene();
    const auto has_box = [](const VirtualhomeNode& node) { return node.has_box; };
    if (!graph.nodes.empty() && std::none_of(graph.nodes.begin(), graph.nodes.end(), has_box)) {
      reader.fail(home,
                  "no node has a bounding box; expected bounding_box or bbox_center and bbox_size, as in a graph "
                  "of the simulator (a trimmed graph says only what is on what)");
      return SourceScene();
    }
    return Importer(graph, knowledge, facts).scene(std::move(id));
  });
}

}  // namespace unietp
