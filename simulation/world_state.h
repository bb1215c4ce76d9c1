#pragma once

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
#include "simulation/floods.h"
#include "simulation/known_start.h"
#include "simulation/link_table.h"
#include "simulation/physics.h"
#include "simulation/profile.h"
#include "simulation/relations.h"
#include "simulation/standing.h"
#include "simulation/view.h"

namespace unietp {

/// Where the hand is, seen from the body: this far ahead and to the left, at the height of the hands, and turned.
struct HandPose {
  double ahead_m = 0.45, left_m = 0, turn = 0;  // radians, counter-clockwise from above
  bool operator==(const HandPose&) const = default;
};

/// The agent, its hand and whether it has said `stop`.
struct AgentState {
  Agent agent;
  HandPose hand;  // back in front of the body whenever something is picked up
  bool stopped = false;
  bool operator==(const AgentState&) const = default;
};

// One change to a state, as the value that was replaced: exchanging it with the present value takes the change back,
// and exchanging again does it again.
struct NodeWas {
  std::size_t node = 0;
  Node value;
};
struct LinksWere {
  std::size_t node = 0;
  std::vector<Link> value;
};
/// The node's body left or entered physics.
struct Lifted {
  std::size_t node = 0;
};
/// A node at the end; here while it is taken back.
struct Added {
  std::optional<Node> value;
};
struct Edit {
  std::variant<Lifted, NodeWas, LinksWere, Added, AgentState> what;
};

/// The inside of World, shared by the files that implement its actions and by nobody else: one moment of an episode,
/// held so that a step costs what it changes. Every change is logged and can be taken back. Relations are kept as links
/// between places; the edges of `scene()` are not kept up to date.
class WorldState {
 public:
  /// Reads all relations from physics, unless they are known; of the start's own edges only those that the agent
  /// carries, and what is attached.
  static Result<WorldState> of(Scene start, const Knowledge& knowledge, const Profile& profile, KnownStart known);

  const Knowledge* knowledge = nullptr;
  const Profile* profile = nullptr;

  const Scene& scene() const { return scene_; }
  const Agent& agent() const { return scene_.agent; }
  const HandPose& hand() const { return hand_; }
  bool stopped() const { return stopped_; }
  const PhysicsWorld& physics() const { return physics_; }
  const Node& node(std::size_t i) const { return scene_.nodes[i]; }
  std::size_t count() const { return scene_.nodes.size(); }
  /// Of a node with its joints as they are, in the world or in the hand.
  const Collider& collider(std::size_t i) const { return *colliders_[i]; }

  std::optional<std::size_t> index_of(std::string_view id) const { return places_.find(id); }
  /// Where things are in the list.
  const NodeIndex& places() const { return places_; }
  bool held(std::string_view id) const;
  /// How feedback may refer to a node: by its id, or as "the" and its category's name.
  FailureReference reference(std::size_t i) const;
  /// The same for a body: a node, the floor or a wall.
  FailureReference reference_to_body(BodyId body) const;
  bool linked(std::size_t from, Predicate relation, std::size_t to) const;
  const std::vector<Link>& links(std::size_t i) const { return links_.of(i); }
  /// What lies on or in a node, directly. Sorted.
  const std::vector<std::uint32_t>& carried(std::size_t i) const { return links_.carried(i); }
  /// The outermost closed container around a node, or nullopt.
  std::optional<std::size_t> closed_around(std::size_t i) const;
  /// A node and all that rests on or in it, the node first, then in scene order.
  std::vector<std::size_t> group_of(std::size_t i) const;
  /// What the hands hold, with all that rests on or in it. Sorted.
  std::vector<std::size_t> in_hand() const;
  /// What there is to look at; what the agent holds and what is inside something closed no eye sees. Valid until the
  /// next change.
  ViewedScene viewed() const;
  /// All edges, sorted: the scene as others see it.
  Scene whole_scene() const;

  /// Where the body can walk now.
  const NavigationGrid& grid() const;
  /// Which cells the agent can walk to; valid until more is asked about ways.
  const CellSet& walk() const;
  /// Where the agent stands, or the free cell nearest to that.
  NavigationGrid::Cell cell() const;
  /// The fewest steps from the agent to a cell of a rectangle, as Ripple::fewest_to tells.
  std::int32_t steps_to(NavigationGrid::Cell low, NavigationGrid::Cell high, std::int32_t most) const;
  /// Where the agent would stand to reach a node that it does not hold, as standing_place of simulation/standing.h.
  std::optional<Vec2> standing_place(std::size_t i) const;

  // Changes. A position in the log marks a moment; going back to it takes back what came after.
  Agent& edit_agent();
  void set_hand(const HandPose& hand);
  void stop();
  /// For states only: what has a part in physics has its own function.
  StateSet& edit_states(std::size_t i);
  void move(std::size_t i, const Pose& pose);
  void set_opening(std::size_t i, double opening);
  void replace(std::size_t i, Node node);
  std::size_t add(Node node);
  /// Takes a node's body out of physics, into the hand; or puts it back where the node is.
  void lift(std::size_t i);
  void lay(std::size_t i);
  /// Adds a link that physics does not show.
  void attach(std::size_t i, std::size_t to);
  /// Re-reads the links near what changed.
  void refresh(std::span<const Bounds> touched, std::span<const std::size_t> changed);
  /// Puts what the hands hold in front of the agent, with all that rests on or in it.
  void carry_along();

  std::size_t mark() const { return log_.size(); }
  void back_to(std::size_t mark);

  /// What changed since the log began, as others see it, and what the state's digest gained by it.
  struct Change {
    Delta seen;
    Digest gained;
  };
  Change change() const;
  /// Ends the log: what it held takes the state from before to now.
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
  void follow(std::size_t i, const Node& before);
  void put_body(std::size_t i);
  void take_in(Node node, std::shared_ptr<const Collider> collider);

  Scene scene_;
  HandPose hand_;
  bool stopped_ = false;
  PhysicsWorld physics_;  // node i is body i; what is in the hands is not in it
  ColliderBook book_;
  SharedList<std::shared_ptr<const Collider>> colliders_;
  NodeIndex places_;
  LinkTable links_;
  std::vector<Edit> log_;

  mutable std::optional<NavigationGrid> grid_;
  mutable std::vector<std::size_t> moved_;  // nodes that the grid has not seen to yet
  mutable Floods floods_;
  mutable std::unordered_map<Digest, StandingCells, DigestHash> standing_;  // by all that decides them
};

/// Does the action; a failed one may leave changes in the log that are to be taken back.
ActionResult perform(WorldState& state, const Action& action);

/// Why the agent cannot act on a node from where it stands (closed container, reach, sight), or nullopt.
std::optional<ActionResult> out_of_hands_way(const WorldState& state, std::size_t node);
/// The same from another place.
std::optional<ActionResult> out_of_hands_way(const WorldState& state, std::size_t node, const Vec2& place);
/// The free cell of a room that the agent can walk to and that is nearest to the middle of its floor.
std::optional<Vec2> place_in_room(const WorldState& state, const Room& room);
/// Turns the agent's head and body towards a point.
void look_at(WorldState& state, const Vec3& point);

// The actions, one function each.
ActionResult go_to(WorldState& state, const std::string& id);
ActionResult turn_to(WorldState& state, std::size_t node);
ActionResult pick_up(WorldState& state, std::size_t node);
/// `within_grasp`: only where the hand can take it back from where the agent stands.
ActionResult place(WorldState& state, std::size_t target, bool inside, bool within_grasp = false);
/// Poses at which `place` could let go of a thing, were it held and they in reach: those that meet nothing.
std::vector<Pose> free_spots(const WorldState& state, std::size_t thing, std::size_t target, bool inside);
ActionResult swing(WorldState& state, std::size_t node, bool open);
ActionResult switch_power(WorldState& state, std::size_t node, bool on);
ActionResult slice(WorldState& state, std::size_t node);
/// The held thing falls from the hand and lies where it comes to rest.
ActionResult drop(WorldState& state);
/// A step, a turn or a tilt of the camera (agent_moves.h).
ActionResult move_body(WorldState& state, ActionType type);
ActionResult reset_head(WorldState& state);
/// Moves or turns the hand that holds something; what it holds must meet nothing.
ActionResult move_hand(WorldState& state, double ahead, double left);
ActionResult rotate_hand(WorldState& state);
ActionResult pour_to(WorldState& state, std::size_t target);
ActionResult use_up(WorldState& state, std::size_t node);
ActionResult wipe(WorldState& state, std::size_t node);
ActionResult spread_to(WorldState& state, std::size_t node);
/// soak_with and the composite actions ..._with: the atomic steps they stand for, each with all its checks.
ActionResult treat_with(WorldState& state, std::size_t tool, std::string_view effect);

/// sit_on and lie_on: `as` is SatOn or LainOn. The body stays at its place beside the seat and faces as the seat does.
ActionResult take_seat(WorldState& state, std::size_t node, Predicate as);
ActionResult stand_up(WorldState& state);
/// Why the body cannot walk or turn (it sits or lies), or nullopt.
std::optional<ActionResult> keeps_seat(const WorldState& state, ActionType type);
ActionResult plug(WorldState& state, std::size_t node, bool in);
ActionResult fold(WorldState& state, std::size_t node);
ActionResult break_apart(WorldState& state, std::size_t node);

/// What a tool does by itself to what lies in or on it, as things are now: effects whose needs are met. `tap_runs`:
/// water flows into it.
void run_processes(WorldState& state, std::size_t tool, bool tap_runs = false);

}  // namespace unietp
