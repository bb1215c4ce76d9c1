#include "simulation/relations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "core/sort_unique.h"
#include "simulation/walls.h"

namespace unietp {
namespace {

constexpr double kUpward = 0.7;         // cosine of about 45°
constexpr double kBelowFloor_m = 0.01;  // tolerance below a cavity's floor
constexpr double kOverhead_m = 2.0;     // `under`: largest distance of what is above
constexpr double kStickOut = 0.85;  // an object's lowest part must be below this fraction of an open cavity's height

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
    const Vec3 center = to_cavity * node.pose.position - cavity.center;
    if (std::abs(center.x()) > cavity.half.x() || std::abs(center.y()) > cavity.half.y()) continue;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners_of(node)) lowest = std::min(lowest, (to_cavity * corner - cavity.center).z());
    if (lowest < -cavity.half.z() - kBelowFloor_m) continue;
    const double highest_start = cavity.half.z() * (2 * kStickOut - 1);
    const bool in = cavity.open_above ? lowest < highest_start : std::abs(center.z()) <= cavity.half.z();
    if (in) return true;
  }
  return false;
}

Link link_to(Predicate relation, BodyId node) { return {relation, static_cast<std::uint32_t>(node.index())}; }

/// next_to: boxes apart by at most kNextTo_m sideways, at overlapping heights, of objects that neither hold nor carry
/// one another (those overlap sideways).
void add_beside(const PhysicsWorld& world, std::span<const BodyId> around, const Bounds& bounds,
                std::vector<Link>& links) {
  for (const BodyId other : around) {
    const Bounds that = world.bounds(other);
    if (bounds.low.z() >= that.high.z() || that.low.z() >= bounds.high.z()) continue;
    const double dx = std::max({bounds.low.x() - that.high.x(), that.low.x() - bounds.high.x()});
    const double dy = std::max({bounds.low.y() - that.high.y(), that.low.y() - bounds.high.y()});
    if (std::max(dx, dy) <= 0) continue;
    const double gap = std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
    if (gap <= kNextTo_m) links.push_back(link_to(Predicate::NextTo, other));
  }
}

bool has(const std::vector<Link>& links, const Link& link) {
  return std::find(links.begin(), links.end(), link) != links.end();
}

/// Adds `inside`, `on`, and `under` for what is above it and neither holds nor supports it.
void add_contacts(const Scene& scene, const PhysicsWorld& world, std::size_t i, const Bounds& bounds,
                  std::span<const BodyId> around, const std::optional<std::uint32_t>& room, std::vector<Link>& links) {
  const Node& node = scene.nodes[i];
  const auto id = BodyId::node(i);
  for (const BodyId other : around) {
    if (world.collider(other).shape.cavities.empty() || !overlap(world.bounds(other), bounds)) continue;
    if (lies_in(node, scene.nodes[other.index()], world.collider(other).shape))
      links.push_back(link_to(Predicate::Inside, other));
  }
  std::vector<BodyId> supports;
  for (const Contact& contact : world.contacts(id, kTouch_m)) {
    if (contact.normal.z() < kUpward) continue;
    if (contact.other == kFloor) {
      if (room) links.push_back({Predicate::OnFloor, *room});
    } else if (contact.other.is_node()) {
      supports.push_back(contact.other);
      if (!has(links, link_to(Predicate::Inside, contact.other)))
        links.push_back(link_to(Predicate::On, contact.other));
    }
  }
  if (!node.movable) return;
  const Vec3 top(node.pose.position.x(), node.pose.position.y(), bounds.high.z());
  const BodyId self[] = {id};
  const auto roof = world.ray(top, top + Vec3(0, 0, kOverhead_m), self);
  if (!roof || !roof->body.is_node() || has(links, link_to(Predicate::Inside, roof->body))) return;
  if (std::find(supports.begin(), supports.end(), roof->body) == supports.end())
    links.push_back(link_to(Predicate::Under, roof->body));
}

void add_agent(const Scene& scene, std::vector<Edge>& edges) {
  const Room* room = room_at(scene, scene.agent.position);
  if (room != nullptr) edges.push_back({Predicate::InRoom, "agent", room->id});
}

void add_links(const Scene& scene, const PhysicsWorld& world, std::size_t i, std::vector<Edge>& edges) {
  for (const Link& link : links_of(scene, world, i)) edges.push_back(edge_of(scene, i, link));
}

void add_rooms(const Scene& scene, PhysicsWorld& world) {
  world.divide_floor(scene.rooms);
  std::size_t wall = 0;
  for (const WallPiece& piece : walls_of(scene)) {
    Shape box;
    box.parts.push_back({Part::Kind::Box, {}, piece.size, -1});
    world.set(BodyId::wall(wall++), box, piece.pose, 0, 0);
  }
}

}  // namespace

PhysicsWorld physics_of(const Scene& scene) {
  ColliderCache colliders;
  return physics_of(scene, colliders);
}

PhysicsWorld physics_of(const Scene& scene, ColliderCache& colliders) {
  PhysicsWorld world;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    world.set(BodyId::node(i), colliders.of(node), node.pose, node.movable ? node.mass : 0);
  }
  add_rooms(scene, world);
  return world;
}

Edge edge_of(const Scene& scene, std::size_t from, const Link& link) {
  const Node& node = scene.nodes[from];
  if (link.relation == Predicate::SliceOf) return {link.relation, node.id, node.slice_of};
  const bool of_room = link.relation == Predicate::InRoom || link.relation == Predicate::OnFloor;
  return {link.relation, node.id, of_room ? scene.rooms[link.to].id : scene.nodes[link.to].id};
}

std::vector<Link> links_of(const Scene& scene, const PhysicsWorld& world, std::size_t i) {
  const Node& node = scene.nodes[i];
  std::vector<Link> links;
  if (!node.slice_of.empty()) links.push_back({Predicate::SliceOf, 0});
  const auto id = BodyId::node(i);
  if (world.has(id)) {  // held objects have no position
    const auto room = world.floor().at(node.pose.position.head<2>());
    if (room) links.push_back({Predicate::InRoom, *room});
    const Bounds bounds = world.bounds(id);
    std::vector<BodyId> around = world.near(bounds, kNextTo_m);
    std::erase_if(around, [&](BodyId other) { return other == id || !other.is_node(); });
    if (!node.movable && bounds.low.z() < kTouch_m) {  // furniture does not move, so no contacts are needed
      if (room) links.push_back({Predicate::OnFloor, *room});
    } else {
      add_contacts(scene, world, i, bounds, around, room, links);
    }
    add_beside(world, around, bounds, links);
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

std::vector<std::size_t> affected_by(const PhysicsWorld& world, std::span<const Bounds> touched,
                                     std::span<const std::size_t> changed) {
  std::vector<std::size_t> affected(changed.begin(), changed.end());
  const auto add = [&](const Bounds& bounds, double gap) {
    for (const BodyId id : world.near(bounds, gap)) {
      if (id.is_node()) affected.push_back(id.index());
    }
  };
  for (const Bounds& bounds : touched) {
    add(bounds, kNextTo_m);
    // `under` may affect objects far below, so the bounds are extended to the floor.
    Bounds column = bounds;
    column.low.z() -= kOverhead_m;
    add(column, 0);
  }
  std::sort(affected.begin(), affected.end());
  affected.erase(std::unique(affected.begin(), affected.end()), affected.end());
  return affected;
}

std::vector<Edge> relations_from(const Scene& scene, const PhysicsWorld& world, std::span<const std::size_t> nodes) {
  std::vector<Edge> edges;
  for (const std::size_t i : nodes) add_links(scene, world, i, edges);
  sort_unique(edges);
  return edges;
}

std::vector<Edge> read_relations(const Scene& scene, const PhysicsWorld& world, std::span<const Edge> carried) {
  std::vector<Edge> edges(carried.begin(), carried.end());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) add_links(scene, world, i, edges);
  add_agent(scene, edges);
  sort_unique(edges);
  return edges;
}

std::vector<Edge> update_relations(const Scene& scene, std::span<const Edge> before, const PhysicsWorld& world,
                                   std::span<const Edge> carried, std::span<const Bounds> touched,
                                   std::span<const std::size_t> changed) {
  const std::vector<std::size_t> affected = affected_by(world, touched, changed);
  std::vector<std::string_view> ids{"agent"};
  for (const std::size_t i : affected) ids.push_back(scene.nodes[i].id);
  std::sort(ids.begin(), ids.end());
  std::vector<Edge> edges(carried.begin(), carried.end());
  for (const Edge& edge : before) {
    if (!std::binary_search(ids.begin(), ids.end(), edge.from)) edges.push_back(edge);
  }
  for (const std::size_t i : affected) add_links(scene, world, i, edges);
  add_agent(scene, edges);
  sort_unique(edges);
  return edges;
}

std::vector<Edge> read_relations(const Scene& scene) { return read_relations(scene, physics_of(scene)); }

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
