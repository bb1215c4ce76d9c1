#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/shared_list.h"
#include "core/shared_set.h"
#include "logic/vocabulary.h"
#include "scene/archetype.h"
#include "scene/geometry.h"
#include "scene/simulator.h"
#include "scene/states.h"

namespace unietp {

/// A room: a floor of one height with walls around it.
struct Room {
  std::string id;    // "kitchen_1"
  std::string type;  // lower case: "kitchen", "living_room", "bedroom", "bathroom", "dining_room", "corridor", …
  std::vector<Vec2> polygon;  // counter-clockwise, meters
  bool operator==(const Room&) const = default;
};

/// A gap in the wall between two rooms through which a body walks.
struct Opening {
  std::string id;
  std::string room_a, room_b;
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();  // ends of the gap on the wall's line
  double height = 2.0;
  bool operator==(const Opening&) const = default;
};

/// A solid box of one particular object, in the object's frame with every joint closed.
struct Board {
  Vec3 center = Vec3::Zero(), size = Vec3::Zero();  // full extents, meters, > 0
  int joint = -1;                                   // moves with this joint of the archetype; -1: with the body
  bool operator==(const Board&) const = default;
};

/// One object: what the simulators know of it plus what physics needs to rebuild it.
struct Node {
  std::string id;        // "mug_3", unique in the scene
  std::string category;  // the simulator's name
  bool movable = false;
  Archetype archetype = Archetype::Box;
  bool openable = false;      // has a door, drawer or lid on a joint
  Vec3 size = Vec3::Zero();   // full extents of the closed body's box in its own frame, meters, > 0
  double mass = 0;            // kilograms
  Pose pose;                  // center of that box in W
  double opening = 0;         // joint position, 0 closed … 1 fully open
  std::vector<Board> boards;  // its own solids, in place of the archetype's; empty: as the archetype says
  StateSet states;
  std::string color, material;  // "" when not known
  std::string asset;            // the simulator's model that this is, "" when it is none
  std::string slice_of;         // id of the whole this was cut from, else ""
  std::string whole_category;   // category of that whole, else ""
  bool operator==(const Node&) const = default;
};

/// A relation that physics showed (contact, containment, floor polygon), or slice_of. Ids of nodes or rooms.
struct Edge {
  Predicate relation = Predicate::On;
  std::string from, to;
  auto operator<=>(const Edge&) const = default;
};
using EdgeSet = SharedSet<Edge>;  // in order of relation, then from, then to

/// Where the agent stands and looks, in W.
struct Agent {
  Vec2 position = Vec2::Zero();
  double yaw = 0;                 // radians, 0 = +x, counter-clockwise from above
  double pitch = 0;               // radians, down is positive
  std::vector<std::string> held;  // ids, one a hand
  bool operator==(const Agent&) const = default;
};

/// The unified scene graph (USG).
struct Scene {
  std::string id;
  Simulator simulator = Simulator::Ai2thor;
  std::vector<Room> rooms;
  std::vector<Opening> openings;
  double wall_height = 2.6;
  double wall_thickness = 0.1;  // centered on the edges of the rooms' polygons
  SharedList<Node> nodes;
  EdgeSet edges;
  Agent agent;
  bool operator==(const Scene&) const = default;
};

/// nullptr when the scene has no such id. Takes time linear in the nodes; NodeIndex is faster.
const Node* find_node(const Scene& scene, std::string_view id);
/// The same, to be changed.
Node* edit_node(Scene& scene, std::string_view id);
/// nullptr when there is no such room.
const Room* find_room(const Scene& scene, std::string_view id);
/// Whether the relation holds between the two, by their ids.
bool has_edge(const Scene& scene, Predicate relation, std::string_view from, std::string_view to);
/// The box around a room from its floor up to a height, meters.
Bounds room_bounds(const Room& room, double height);
/// Room whose polygon holds the point, or nullptr.
const Room* room_at(const Scene& scene, const Vec2& point);

}  // namespace unietp
