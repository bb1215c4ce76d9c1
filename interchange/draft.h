#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "interchange/import_scene.h"
#include "interchange/source_scene.h"
#include "scene/scene.h"

namespace unietp {

inline constexpr double kArrived_m = 0.02;  // an object that is nearer to the file's pose has arrived
inline constexpr double kOnFloor_m = 0.05;  // the lowest point of what is higher is not on the floor

/// What became of one relation that the file states between known objects.
struct DraftRelation {
  SourceRelation::Kind kind = SourceRelation::Kind::OnOrInside;
  std::size_t object = 0;                 // position in SourceScene::objects
  std::size_t receptacle = 0;             // the same
  std::optional<std::size_t> node, held;  // positions in Scene::nodes, where object and receptacle are nodes
};

/// A repair of a node, and the node for which it was made.
struct DraftRepair {
  std::size_t node = 0;
  RepairKind kind = RepairKind::Cut;
  std::optional<std::size_t> other;
  double by_m = 0;
};

/// A scene on its way in.
struct Draft {
  Scene scene;
  std::vector<std::size_t> source_of;  // of each node: position in SourceScene::objects
  std::vector<Vec3> file_center;       // of each node: middle of the file's box, W
  std::vector<Vec3> center_in_node;    // the same point in the node's frame, as it was placed
  std::vector<std::size_t> structure;  // floors, walls, doors: positions in SourceScene::objects
  std::vector<DraftRelation> relations;
  std::vector<DraftRepair> repairs;
  std::vector<bool> heaped;  // of each node: part of a heap, see fix_heaps
  ImportReport report;
};

/// Rooms and openings of the file; drawn around the objects where it has none. Outlines are counter-clockwise. Rooms
/// that the file numbers have ids of ours, "kitchen_1", without `own_ids`.
void draw_rooms(const SourceScene& source, Scene& scene, bool own_ids = false);

/// Nodes for all that can be placed, in the file's order, and the relations among them; the rest as issues. `scene` has
/// its rooms.
Draft draft_of(const SourceScene& source, Scene scene, const Knowledge& knowledge, const FormatFacts& facts,
               bool own_ids = false);

/// The box of a node's solids as its joints stand, W.
Bounds box_of(const Node& node);

/// Fixes heaps in place and lists them: movable things of which one has more than a dozen others in its box that it
/// neither holds nor stands on, with all that reaches into them. No physics brings such things apart in bounded time,
/// and nothing is cut for them.
void fix_heaps(const SourceScene& source, Draft& draft);

/// Turns furniture whose doors or drawers something fixed, or the end of every room, is right before, so that they
/// open: to its other side, else by a quarter, its box staying as it is. Some files do not say which side is the front,
/// or do not say it well.
void turn_fronts(const SourceScene& source, const FormatFacts& facts, Draft& draft);

/// Cuts out of furniture what the doors and drawers of other furniture pass through, if that is no more than 10 cm: the
/// front of a dresser whose drawers are objects of their own, a carpet, the edge of a neighbor.
void clear_doors(Draft& draft);

/// Gives furniture boards where the file shows that something stands, and thins solids that would overlap what moves.
void follow_evidence(Draft& draft);

/// Lets everything that moves come to rest. What still moves by 2 mm in two seconds of physics is held in place (it
/// cannot be picked up then) and listed: nothing in the scene moves farther afterwards. When the work of all that
/// passes `most_work`, everything is held where it is then; where the file has it, when the first fall is not over by
/// then.
void come_to_rest(const SourceScene& source, std::size_t most_work, Draft& draft);

/// Sets the agent where the file has it, or on free floor. Lists rooms that it cannot walk to.
void place_agent(const SourceScene& source, const Profile& profile, Draft& draft);

/// How many objects stand within kArrived_m of the file's pose; the others as issues when `list`.
int count_in_place(const SourceScene& source, Draft& draft, bool list);

/// Puts the draft's repairs of a millimeter or more into its report, in order of the nodes.
void report_repairs(const SourceScene& source, Draft& draft);

/// Counts the relations that still hold, and lists the others. Edges must have been read.
void compare_relations(const SourceScene& source, const FormatFacts& facts, Draft& draft);

}  // namespace unietp
