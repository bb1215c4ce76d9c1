#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "simulation/collider.h"
#include "simulation/physics.h"

namespace unietp {

inline constexpr double kTouch_m = 0.004;  // bodies nearer than this touch
inline constexpr double kNextTo_m = 0.2;   // next_to: largest gap between boxes at overlapping heights

/// Walls of all rooms with gaps at the openings, and every node, as bodies: node i is body i. With a cache, equal
/// shapes share their colliders.
PhysicsWorld physics_of(const Scene& scene);
/// The same with a cache of colliders.
PhysicsWorld physics_of(const Scene& scene, ColliderCache& colliders);

/// A relation of one node by positions instead of ids: `to` is the place of a node in Scene::nodes, or of a room in
/// Scene::rooms (in_room, on_floor); of slice_of, which the node tells itself, 0.
struct Link {
  Predicate relation = Predicate::On;
  std::uint32_t to = 0;
  auto operator<=>(const Link&) const = default;
};
/// A link with the ids of its ends.
Edge edge_of(const Scene& scene, std::size_t from, const Link& link);
/// Whether the link is of support or containment.
inline bool carries(const Link& link) { return link.relation == Predicate::On || link.relation == Predicate::Inside; }

/// The links of one node, read from physics, sorted: on (contact from above: the contact's normal leans less than 45°
/// from straight up, and not inside it), inside (the box's lowest part and the center's footprint lie in the cavity;
/// true of every enclosing cavity), on_floor (contact with the floor), in_room (floor polygon under the center), under,
/// next_to, and slice_of from the node. A node without a body (it is in the hand) has only in_room and slice_of.
std::vector<Link> links_of(const Scene& scene, const PhysicsWorld& world, std::size_t node);

/// Positions of the nodes whose links a change may affect: those `changed` and those near the bounds, old and
/// new, of what moved (`touched`). Sorted.
std::vector<std::size_t> affected_by(const PhysicsWorld& world, std::span<const Bounds> touched,
                                     std::span<const std::size_t> changed);

/// The links of all nodes and in_room of the agent as edges, sorted. Held objects and what they carry keep the edges
/// that `carried` gives and have no others.
std::vector<Edge> read_relations(const Scene& scene, const PhysicsWorld& world, std::span<const Edge> carried = {});

/// The same after a change to a scene that had the edges `before`: re-reads only the nodes `changed` and those near the
/// bounds, old and new, of what moved (`touched`).
std::vector<Edge> update_relations(const Scene& scene, std::span<const Edge> before, const PhysicsWorld& world,
                                   std::span<const Edge> carried, std::span<const Bounds> touched,
                                   std::span<const std::size_t> changed);
/// Those of read_relations that start at the given nodes, sorted.
std::vector<Edge> relations_from(const Scene& scene, const PhysicsWorld& world, std::span<const std::size_t> nodes);

/// The same for a scene at rest with nothing held.
std::vector<Edge> read_relations(const Scene& scene);

/// Ids of everything that rests on or in `id`, directly or indirectly, in scene order.
std::vector<std::string> carried_by(const Scene& scene, std::string_view id);

}  // namespace unietp
