#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"
#include "simulation/physics.h"

namespace unietp {

inline constexpr double kTouch_m = 0.004;  // bodies nearer than this touch
inline constexpr double kNextTo_m = 0.2;   // next_to: largest gap between boxes at overlapping heights

/// Walls of all rooms with gaps at the openings, and every node, as bodies: node i is body i.
PhysicsWorld physics_of(const Scene& scene);

/// What physics shows, sorted: on (contact from above: the contact's normal leans less than 45° from straight up, and
/// not inside it), inside (the box's lowest part and the centre's footprint lie in the cavity; true of every enclosing
/// cavity), on_floor (contact with the floor), in_room (floor polygon under the centre; also of the agent), under,
/// next_to, and slice_of from the nodes. Held objects and what they carry keep the edges that `carried` gives and have
/// no others.
std::vector<Edge> read_relations(const Scene& scene, const PhysicsWorld& world, std::span<const Edge> carried = {});

/// The same result as read_relations after a change, at the cost of the change: re-reads only nodes in `changed`
/// (indices) and those near the bounds, old and new, of what moved (`touched`).
std::vector<Edge> update_relations(const Scene& scene, const PhysicsWorld& world, std::span<const Edge> carried,
                                   std::span<const Bounds> touched, std::span<const std::size_t> changed);
/// The same for a scene whose edges are to be taken for `before`.
std::vector<Edge> update_relations(const Scene& scene, std::span<const Edge> before, const PhysicsWorld& world,
                                   std::span<const Edge> carried, std::span<const Bounds> touched,
                                   std::span<const std::size_t> changed);
/// Those of read_relations that start at the given nodes, sorted.
std::vector<Edge> relations_from(const Scene& scene, const PhysicsWorld& world, std::span<const std::size_t> nodes);

/// Convenience for a scene at rest with nothing held.
std::vector<Edge> read_relations(const Scene& scene);

/// Ids of everything that rests on or in `id`, directly or through others, in scene order.
std::vector<std::string> carried_by(const Scene& scene, std::string_view id);

}  // namespace unietp
