#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "core/sort_unique.h"
#include "scene/action.h"
#include "scene/node_index.h"
#include "scene/scene.h"
#include "scene/trace.h"
#include "simulation/action_result.h"
#include "simulation/digest.h"
#include "simulation/flood_cache.h"
#include "simulation/known_start.h"
#include "simulation/link_table.h"
#include "simulation/physics.h"
#include "simulation/profile.h"
#include "simulation/relations.h"
#include "simulation/standing.h"
#include "simulation/view.h"

namespace unietp {

/// Pose of the hand relative to the body, at a fixed height.
struct HandPose {
  double ahead_m = 0.45, left_m = 0, turn = 0;  // radians, counter-clockwise from above
  bool operator==(const HandPose&) const = default;
};

/// The agent, its hand and whether it has said `stop`.
struct AgentState {
  Agent agent;
  HandPose hand;  // reset whenever something is picked up
  bool stopped = false;
  bool operator==(const AgentState&) const = default;
};

// One change to a state, as the value that was replaced: exchanging it with the current value undoes the change, and
// exchanging again redoes it.
/// A node was replaced.
struct NodeEdit {
  std::size_t node = 0;
  Node value;
};
/// The links of a node were replaced.
struct LinksEdit {
  std::size_t node = 0;
  std::vector<Link> value;
};
/// A node's body was removed from physics or put back.
struct BodyToggle {
  std::size_t node = 0;
};
/// A node was added at the end; has a value while the change is undone.
struct NodeAddition {
  std::optional<Node> value;
};
/// One entry of the undo log.
struct Edit {
  std::variant<BodyToggle, NodeEdit, LinksEdit, NodeAddition, AgentState> what;
};

/// The implementation of World, used only by the files that implement actions: one state of an episode, with an undo
/// log, so that a step costs what it changes. Relations are stored as links between positions; the edges of `scene()`
/// are not kept up to date.
class WorldState {
 public:
  /// Reads all relations from physics, unless they are known. Of the start's edges it uses only those of what the agent
  /// carries and those of attached objects.
  static Result<WorldState> of(Scene start, const Knowledge& knowledge, const Profile& profile, KnownStart known);

  const Knowledge* knowledge = nullptr;
  const Profile* profile = nullptr;

  const Scene& scene() const { return scene_; }  // as it is now
  const Agent& agent() const { return scene_.agent; }
  const HandPose& hand() const { return hand_; }                     // relative to the body
  bool stopped() const { return stopped_; }                          // the agent ended the episode
  const PhysicsWorld& physics() const { return physics_; }           // with the bodies where they are now
  const Node& node(std::size_t i) const { return scene_.nodes[i]; }  // by position in the scene
  std::size_t count() const { return scene_.nodes.size(); }          // of nodes
  /// Of a node with its joints as they are, in the world or in the hand.
  const Collider& collider(std::size_t i) const { return *colliders_[i]; }

  std::optional<std::size_t> index_of(std::string_view id) const { return places_.find(id); }  // of a node, if known
  /// Positions of nodes by id and category.
  const NodeIndex& places() const { return places_; }
  bool held(std::string_view id) const;
  /// How feedback may refer to a node: by its id, or as "the" and its category's name.
  FailureReference reference(std::size_t i) const;
  /// The same for a body: a node, the floor or a wall.
  FailureReference reference_to_body(BodyId body) const;
  /// Whether the relation holds between two nodes, by position.
  bool linked(std::size_t from, Predicate relation, std::size_t to) const;
  const std::vector<Link>& links(std::size_t i) const { return links_.of(i); }
  /// What lies directly on or in a node. Sorted.
  const std::vector<std::uint32_t>& carried(std::size_t i) const { return links_.carried(i); }
  /// The outermost closed container around a node, or nullopt.
  std::optional<std::size_t> closed_around(std::size_t i) const;
  /// A node and all that rests on or in it, the node first, then in scene order.
  std::vector<std::size_t> group_of(std::size_t i) const;
  /// What the hands hold, with all that rests on or in it. Sorted.
  std::vector<std::size_t> in_hand() const;
  /// The scene for rendering, without what the agent holds or what is inside something closed. Valid until the next
  /// change.
  ViewedScene viewed() const;
  /// The scene with all edges, sorted.
  Scene whole_scene() const;

  /// Free cells in the current state.
  const NavigationGrid& grid() const;
  /// Cells that the agent can walk to; valid until the next query about walking.
  const CellSet& walk() const;
  /// Where the agent stands, or the free cell nearest to that.
  NavigationGrid::Cell cell() const;
  /// The fewest steps from the agent to a cell of a rectangle, as DistanceField::fewest_to tells.
  std::int32_t steps_to(NavigationGrid::Cell low, NavigationGrid::Cell high, std::int32_t most) const;
  /// Where the agent would stand to reach a node that it does not hold, as standing_place of simulation/standing.h.
  std::optional<Vec2> standing_place(std::size_t i) const;

  // Changes. Each is logged; `back_to(mark)` undoes those after the mark.
  Agent& edit_agent();
  void set_hand(const HandPose& hand);
  void stop();
  /// For states only; pose, opening and shape have functions of their own.
  StateSet& edit_states(std::size_t i);
  void move(std::size_t i, const Pose& pose);
  void set_opening(std::size_t i, double opening);
  void replace(std::size_t i, Node node);
  std::size_t add(Node node);
  /// Removes a node's body from physics (it is held), or puts it back at the node's pose.
  void lift(std::size_t i);
  void lay(std::size_t i);
  /// Adds an `attached` link, which cannot be read from physics.
  void attach(std::size_t i, std::size_t to);
  /// Reads the links of the changed nodes and of those near the bounds again.
  void refresh(std::span<const Bounds> touched, std::span<const std::size_t> changed);
  /// Moves held objects, with all that rests on or in them, to the hand's pose.
  void carry_along();

  /// A point to go back to.
  std::size_t mark() const { return log_.size(); }
  void back_to(std::size_t mark);

  /// What changed since a mark of the log, and the difference of the state's digest.
  struct Change {
    Delta delta;
    Digest digest_difference;
  };
  Change change(std::size_t since = 0) const;
  /// Takes the log out: its edits lead from the state at its start to the current one.
  std::vector<Edit> take_log();
  void redo(std::vector<Edit>& log);
  void undo(std::vector<Edit>& log);

 private:
  WorldState() = default;
  template <class Was>
  void log(Was was) {
    log_.emplace_back().what.emplace<Was>(std::move(was));
  }
  void exchange(Edit& edit);
  void read_links(const EdgeSet& edges);
  void add_link(std::size_t i, const Link& link);
  void log_node(std::size_t i);
  void log_agent();
  void update_body(std::size_t i, const Node& before);
  void put_body(std::size_t i);
  void append(Node node, std::shared_ptr<const Collider> collider);

  Scene scene_;
  HandPose hand_;
  bool stopped_ = false;
  PhysicsWorld physics_;  // node i is body i; what is in the hands is not in it
  ColliderCache colliders_made_;
  SharedList<std::shared_ptr<const Collider>> colliders_;
  NodeIndex places_;
  LinkTable links_;
  std::vector<Edit> log_;

  mutable std::optional<NavigationGrid> grid_;
  mutable std::vector<std::size_t> moved_;  // nodes that the grid is not updated for
  mutable FloodCache floods_;
  mutable std::unordered_map<Digest, StandingCells, DigestHash> standing_;  // by a digest of their inputs
};

/// Called between two atomic steps of one action: the state is one that the agent passes through.
using PassesThrough = std::function<void()>;
/// Performs the action; after a failure the caller must undo the changes in the log.
ActionResult perform(WorldState& state, const Action& action, const PassesThrough& passes);

/// Why the agent cannot act on a node by hand from its position (closed container, reach, sight), or nullopt.
std::optional<ActionResult> access_failure(const WorldState& state, std::size_t node);
/// The same from another position.
std::optional<ActionResult> access_failure(const WorldState& state, std::size_t node, const Vec2& place);
/// The free cell of a room that the agent can walk to and that is nearest to the middle of its floor.
std::optional<Vec2> place_in_room(const WorldState& state, const Room& room);
/// Turns the agent's head and body toward a point.
void look_at(WorldState& state, const Vec3& point);

// The actions, one function each. Each checks its needs in the order of the action table and changes the state on
// success.
ActionResult go_to(WorldState& state, const std::string& id);
/// The agent and its camera turn toward the node.
ActionResult turn_to(WorldState& state, std::size_t node);
/// The node, with all that rests on or in it, goes into the hand.
ActionResult pick_up(WorldState& state, std::size_t node);
/// place_on, or place_in with `inside`. `within_grasp`: only where the agent can pick it up again from its position.
ActionResult place(WorldState& state, std::size_t target, bool inside, bool within_grasp = false);
/// Collision-free poses at which `place` could release an object, in reach or not.
std::vector<Pose> free_spots(const WorldState& state, std::size_t thing, std::size_t target, bool inside);
/// open or close.
ActionResult swing(WorldState& state, std::size_t node, bool open);
/// turn_on or turn_off.
ActionResult switch_power(WorldState& state, std::size_t node, bool on);
/// Replaces the node by its slices.
ActionResult slice(WorldState& state, std::size_t node);
/// The held object falls and stays where it comes to rest.
ActionResult drop(WorldState& state);
/// A step, a turn or a tilt of the camera (agent_moves.h).
ActionResult move_body(WorldState& state, ActionType type);
/// The camera looks straight ahead.
ActionResult reset_head(WorldState& state);
/// Moves or turns the hand that holds something; what it holds must meet nothing.
ActionResult move_hand(WorldState& state, double ahead, double left);
/// Turns the hand with what it holds by a fixed angle.
ActionResult rotate_hand(WorldState& state);
/// The contents of the held vessel go into the target, or down its drain.
ActionResult pour_to(WorldState& state, std::size_t target);
/// The node is used up.
ActionResult use_up(WorldState& state, std::size_t node);
/// The node becomes clean and uncovered, by the held cloth.
ActionResult wipe(WorldState& state, std::size_t node);
/// The node is covered with what the held dispenser gives.
ActionResult spread_to(WorldState& state, std::size_t node);
/// soak_with and the composite actions: performs their atomic steps, each with all its checks.
ActionResult treat_with(WorldState& state, std::size_t tool, Treatment treatment, const PassesThrough& passes);

/// The actions of the profile `wide` on an object. A body that sits or lies stays at its place beside the seat and
/// faces as the seat does.
ActionResult perform_extension(WorldState& state, ActionType type, std::size_t node);
/// The body leaves its seat and stands beside it.
ActionResult stand_up(WorldState& state);
/// Why the agent cannot walk or turn because it sits or lies, or nullopt.
std::optional<ActionResult> seated_failure(const WorldState& state, ActionType type);

/// Applies the effects of a tool on what lies in or on it whose needs are met. `tap_runs`: water flows into it.
void run_processes(WorldState& state, std::size_t tool, bool tap_runs = false);

}  // namespace unietp
