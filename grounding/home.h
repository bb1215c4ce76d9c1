#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "akb/knowledge.h"
#include "grounding/collision.h"
#include "grounding/reachability.h"
#include "scene/node_index.h"
#include "scene/scene.h"
#include "scene/trace.h"
#include "simulation/link_table.h"
#include "simulation/physics.h"
#include "simulation/profile.h"
#include "simulation/view.h"

namespace unietp {

/// A scene with all that grounding asks of it again and again, worked out once, so that a candidate costs what it
/// changes and not what the home holds. Never changes; threads may share it.
struct Home {
  Scene scene;                      // its edges as physics shows them
  NodeIndex places;                 // of its nodes
  std::vector<std::int32_t> rooms;  // by node: the place of the room around its middle, -1 for none
  PhysicsWorld physics;             // of the scene, prepared
  LinkTable links;                  // of its nodes
  SharedList<std::shared_ptr<const Collider>> colliders;  // by node
  std::shared_ptr<const PlacementChecker> solids;         // of the scene
  SharedList<Bounds> bounds;                              // of each node where it stands
  SharedList<std::optional<Bounds>> sweeps;  // space that doors and drawers of furniture pass through, by node
  double farthest_sweep = 0;                 // how far any of them goes beyond the bounds of its node, m
  std::shared_ptr<const Walk> walk;
  std::vector<std::string> cut_off;      // rooms that the agent cannot walk to: none in generated homes
  std::vector<bool> out_of_reach;        // by node: furniture of a given home that the agent does not get at, or
  std::vector<bool> stuck;               // of which no door or drawer opens; both empty in generated homes
  Trace now;                             // the scene in the logic, without comparisons
  FactReader reader;                     // that read it
  std::shared_ptr<const Viewer> viewer;  // for its rooms
};

/// Reads the scene's edges anew. Deterministic.
Home prepare_home(Scene scene, const Profile& profile);

/// Whether the agent gets at a node of the home and can put things on it, or into it.
bool is_of_use(const Home& home, std::size_t node, bool inside);

/// Id of a room that the agent can walk to in the home and not in a scene that grew out of it, or nullopt. A room of a
/// real home that nobody can walk to is there, and no reason to make no tasks in the others. `walk`: of the scene.
std::optional<std::string> newly_unreached(const Home& home, const Scene& scene,
                                           const std::shared_ptr<const Walk>& walk);

/// The space that a node's moving parts pass through when it is opened, in W; nullopt when nothing moves.
std::optional<Bounds> sweep_of(const Node& node);
/// How far a space goes beyond some bounds, along the axis where it goes farthest; 0 for one within them or none, m.
double goes_beyond(const std::optional<Bounds>& space, const Bounds& bounds);

/// Whether two nodes are one thing with the same body in the same place: states and colors may differ, relations
/// cannot.
bool same_body(const Node& a, const Node& b);

/// What a scene that grew out of a home differs in, node by node as they stand in the two lists.
struct Differences {
  std::vector<std::size_t> nodes;   // of the scene: changed in body or place, or not in the home
  std::vector<std::size_t> gone;    // of the home: no longer where they stood, or changed in body or place
  std::vector<std::size_t> states;  // of both: changed, but same_body
};
Differences differences(const Home& home, const Scene& scene);

/// The bodies of such a scene, at the cost of the differences.
PhysicsWorld physics_of(const Home& home, const Scene& scene, const Differences& changed);
/// Where a body can stand in it, when it may have changed at some `places` of the lists: nullopt while nothing that a
/// body bumps into has.
std::optional<NavigationGrid> other_grid(const Home& home, const Scene& scene, std::vector<std::size_t> places);
/// Where it can walk: the home's own while there is no other grid and the agent stands where it stood.
std::shared_ptr<const Walk> walk_of(const Home& home, const Scene& scene, std::vector<std::size_t> places);
/// A copy of all but the edges, most of which are two names each.
Scene without_edges(const Scene& scene);
/// The place of the room at a point in Scene::rooms, -1 for none.
std::int32_t room_number(const PhysicsWorld& world, const Vec2& point);

}  // namespace unietp
