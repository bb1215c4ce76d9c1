#include "simulation/relations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "simulation/walls.h"

namespace unietp {
namespace {

constexpr double kUpward = 0.7;     // cosine of about 45°
constexpr double kSunk_m = 0.01;    // how far below a cavity's floor something may seem to lie
constexpr double kStickOut = 0.85;  // an object's lowest part must lie under this share of an open cavity's height

std::vector<Vec3> corners_of(const Node& node) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3 half = node.size / 2;
    corners.push_back(node.pose * Vec3((i & 1) ? half.x() : -half.x(), (i & 2) ? half.y() : -half.y(),
                                       (i & 4) ? half.z() : -half.z()));
  }
  return corners;
}

bool lies_in(const Node& node, const Node& container, const Shape& shape) {
  for (const Cavity& cavity : shape.cavities) {
    const Pose to_cavity = inverse(container.pose * joint_motion(shape, cavity.joint, container.opening));
    const Vec3 centre = to_cavity * node.pose.position - cavity.centre;
    if (std::abs(centre.x()) > cavity.half.x() || std::abs(centre.y()) > cavity.half.y()) continue;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners_of(node)) lowest = std::min(lowest, (to_cavity * corner - cavity.centre).z());
    if (lowest < -cavity.half.z() - kSunk_m) continue;
    const double highest_start = cavity.half.z() * (2 * kStickOut - 1);
    const bool in = cavity.open_above ? lowest < highest_start : std::abs(centre.z()) <= cavity.half.z();
    if (in) return true;
  }
  return false;
}

/// Reads relations of single nodes; remembers shapes and bounds.
class Reader {
 public:
  Reader(const Scene& scene, const PhysicsWorld& world) : scene_(scene), world_(world), shapes_(scene.nodes.size()) {}

  void relations_from(std::size_t i, std::vector<Edge>& edges) {
    const Node& node = scene_.nodes[i];
    const auto id = static_cast<BodyId>(i);
    const Room* room = room_at(scene_, node.pose.position.head<2>());
    if (room != nullptr) edges.push_back({Predicate::InRoom, node.id, room->id});
    if (!node.slice_of.empty()) edges.push_back({Predicate::SliceOf, node.id, node.slice_of});
    if (!world_.has(id)) return;
    const Bounds bounds = world_.bounds(id);
    if (!node.movable && bounds.low.z() < kTouch_m) {  // furniture stands where it was put; no need to ask contacts
      if (room != nullptr) edges.push_back({Predicate::OnFloor, node.id, room->id});
      beside(i, bounds, edges);
      return;
    }
    std::vector<std::string> around;
    for (const BodyId other : world_.near(bounds, 0)) {
      if (other == id || other >= scene_.nodes.size()) continue;
      if (lies_in(node, scene_.nodes[other], shape(other))) {
        around.push_back(scene_.nodes[other].id);
        edges.push_back({Predicate::Inside, node.id, scene_.nodes[other].id});
      }
    }
    std::vector<std::string> supports;
    for (const Contact& contact : world_.contacts(id, kTouch_m)) {
      if (contact.normal.z() < kUpward) continue;
      if (contact.other == kFloor) {
        if (room != nullptr) edges.push_back({Predicate::OnFloor, node.id, room->id});
      } else if (contact.other < scene_.nodes.size()) {
        const std::string& support = scene_.nodes[contact.other].id;
        supports.push_back(support);
        if (std::find(around.begin(), around.end(), support) == around.end()) {
          edges.push_back({Predicate::On, node.id, support});
        }
      }
    }
    beside(i, bounds, edges);
    if (!node.movable) return;
    const Vec3 top(node.pose.position.x(), node.pose.position.y(), bounds.high.z());
    const BodyId self[] = {id};
    const auto roof = world_.ray(top, top + Vec3(0, 0, 2.0), self);
    if (roof && roof->body < scene_.nodes.size()) {
      const std::string& over = scene_.nodes[roof->body].id;
      const bool holds = std::find(around.begin(), around.end(), over) != around.end() ||
                         std::find(supports.begin(), supports.end(), over) != supports.end();
      if (!holds) edges.push_back({Predicate::Under, node.id, over});
    }
  }

 private:
  const Shape& shape(std::size_t i) {
    if (!shapes_[i]) shapes_[i] = shape_of(scene_.nodes[i]);
    return *shapes_[i];
  }

  /// next_to: boxes apart by at most kNextTo_m sideways, at overlapping heights, of objects that neither hold nor carry
  /// one another (those overlap sideways).
  void beside(std::size_t i, const Bounds& bounds, std::vector<Edge>& edges) const {
    for (const BodyId other : world_.near(bounds, kNextTo_m)) {
      if (other == i || other >= scene_.nodes.size()) continue;
      const Bounds that = world_.bounds(other);
      if (bounds.low.z() >= that.high.z() || that.low.z() >= bounds.high.z()) continue;
      const double dx = std::max({bounds.low.x() - that.high.x(), that.low.x() - bounds.high.x()});
      const double dy = std::max({bounds.low.y() - that.high.y(), that.low.y() - bounds.high.y()});
      if (std::max(dx, dy) <= 0) continue;
      const double gap = std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
      if (gap <= kNextTo_m) edges.push_back({Predicate::NextTo, scene_.nodes[i].id, scene_.nodes[other].id});
    }
  }

  const Scene& scene_;
  const PhysicsWorld& world_;
  std::vector<std::optional<Shape>> shapes_;  // made when first asked for
};

void sort_unique(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

void add_agent(const Scene& scene, std::vector<Edge>& edges) {
  const Room* room = room_at(scene, scene.agent.position);
  if (room != nullptr) edges.push_back({Predicate::InRoom, "agent", room->id});
}

}  // namespace

PhysicsWorld physics_of(const Scene& scene) {
  PhysicsWorld world;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    world.set(static_cast<BodyId>(i), shape_of(node), node.pose, node.opening, node.movable ? node.mass : 0);
  }
  BodyId wall = kFirstWall;
  for (const WallPiece& piece : walls_of(scene)) {
    Shape box;
    box.parts.push_back({Part::Kind::Box, {}, piece.size, -1});
    world.set(wall++, box, piece.pose, 0, 0);
  }
  return world;
}

std::vector<Edge> read_relations(const Scene& scene, const PhysicsWorld& world, std::span<const Edge> carried) {
  std::vector<Edge> edges(carried.begin(), carried.end());
  Reader reader(scene, world);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) reader.relations_from(i, edges);
  add_agent(scene, edges);
  sort_unique(edges);
  return edges;
}

std::vector<Edge> read_relations(const Scene& scene) { return read_relations(scene, physics_of(scene)); }

std::vector<Edge> relations_from(const Scene& scene, const PhysicsWorld& world, std::span<const std::size_t> nodes) {
  std::vector<Edge> edges;
  Reader reader(scene, world);
  for (const std::size_t i : nodes) reader.relations_from(i, edges);
  sort_unique(edges);
  return edges;
}

std::vector<Edge> update_relations(const Scene& scene, const PhysicsWorld& world, std::span<const Edge> carried,
                                   std::span<const Bounds> touched, std::span<const std::size_t> changed) {
  return update_relations(scene, scene.edges, world, carried, touched, changed);
}

std::vector<Edge> update_relations(const Scene& scene, std::span<const Edge> before, const PhysicsWorld& world,
                                   std::span<const Edge> carried, std::span<const Bounds> touched,
                                   std::span<const std::size_t> changed) {
  std::vector<bool> affected(scene.nodes.size(), false);
  for (const std::size_t i : changed) affected[i] = true;
  for (const Bounds& bounds : touched) {
    for (const BodyId id : world.near(bounds, kNextTo_m)) {
      if (id < affected.size()) affected[id] = true;
    }
    // What lies under something that moved is not near it; a column below covers the rays of `under`.
    Bounds column = bounds;
    column.low.z() -= 2.0;
    for (const BodyId id : world.near(column, 0)) {
      if (id < affected.size()) affected[id] = true;
    }
  }
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < affected.size(); ++i) {
    if (affected[i]) ids.push_back(scene.nodes[i].id);
  }
  ids.emplace_back("agent");
  std::sort(ids.begin(), ids.end());
  std::vector<Edge> edges(carried.begin(), carried.end());
  for (const Edge& edge : before) {
    if (!std::binary_search(ids.begin(), ids.end(), edge.from)) edges.push_back(edge);
  }
  Reader reader(scene, world);
  for (std::size_t i = 0; i < affected.size(); ++i) {
    if (affected[i]) reader.relations_from(i, edges);
  }
  add_agent(scene, edges);
  sort_unique(edges);
  return edges;
}

std::vector<std::string> carried_by(const Scene& scene, std::string_view id) {
  std::vector<std::string> carried{std::string(id)};
  for (std::size_t at = 0; at < carried.size(); ++at) {
    for (const Edge& edge : scene.edges) {
      if (edge.to != carried[at] || (edge.relation != Predicate::On && edge.relation != Predicate::Inside)) continue;
      if (std::find(carried.begin(), carried.end(), edge.from) == carried.end()) carried.push_back(edge.from);
    }
  }
  carried.erase(carried.begin());
  std::vector<std::string> in_scene_order;
  for (const Node& node : scene.nodes) {
    if (std::find(carried.begin(), carried.end(), node.id) != carried.end()) in_scene_order.push_back(node.id);
  }
  return in_scene_order;
}

}  // namespace unietp
