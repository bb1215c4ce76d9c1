#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "scene/action.h"
#include "scene/scene.h"
#include "simulation/navigation.h"
#include "simulation/physics.h"
#include "simulation/profile.h"
#include "simulation/view.h"
#include "simulation/world.h"

namespace unietp {

/// Where the hand is, seen from the body: this far ahead and to the left, at the height of the hands, and turned.
struct HandPose {
  double ahead_m = 0.45, left_m = 0, turn = 0;  // radians, counter-clockwise from above
};

/// The inside of World, shared by the files that implement its actions and by nobody else.
struct WorldState {
  Scene scene;
  const Knowledge* knowledge = nullptr;
  const Profile* profile = nullptr;
  PhysicsWorld physics;  // node i is body i; what is in the hands is not in it
  bool stopped = false;
  mutable Viewer viewer;  // a workplace for looking
  HandPose hand;          // back in front of the body whenever something is picked up

  /// Where the body can walk now, and the steps from the agent to every cell; made at the first question after a
  /// change.
  const NavigationGrid& grid() const;
  const std::vector<std::int32_t>& walk() const;
  void forget_grid();
  void forget_walk();

  std::optional<std::size_t> index_of(std::string_view id) const;
  Node& node(std::size_t i) { return scene.nodes[i]; }
  const Node& node(std::size_t i) const { return scene.nodes[i]; }
  bool held(std::string_view id) const;
  /// The outermost closed container around a node, or nullopt.
  std::optional<std::size_t> closed_around(std::size_t i) const;
  /// A node and all that rests on or in it, as indices, the node first.
  std::vector<std::size_t> group_of(std::size_t i) const;
  /// Re-reads the edges near what changed.
  void refresh(std::span<const Bounds> touched, std::span<const std::size_t> changed);
  /// Puts what the hands hold in front of the agent, with all that rests on or in it.
  void carry_along();
  /// Adds those of the `attached` edges before a change whose object still rests on what it was attached to.
  void keep_attached(std::span<const Edge> before);

 private:
  mutable std::optional<NavigationGrid> grid_;
  mutable std::vector<std::int32_t> walk_;
};

inline Outcome succeeded() { return {true, Failure::None, ""}; }
inline Outcome failed(Failure failure, std::string feedback) { return {false, failure, std::move(feedback)}; }

/// Why the agent cannot act on a node from where it stands (closed container, reach, sight), or nullopt.
std::optional<Outcome> out_of_hands_way(const WorldState& state, std::size_t node);
/// The free cell of a room that the agent can walk to and that is nearest to the middle of its floor.
std::optional<Vec2> place_in_room(const WorldState& state, const Room& room);
/// Turns the agent's head and body towards a point.
void look_at(WorldState& state, const Vec3& point);

// The actions, one function each. A failed one leaves the state as it was.
Outcome go_to(WorldState& state, const std::string& id);
Outcome turn_to(WorldState& state, std::size_t node);
Outcome pick_up(WorldState& state, std::size_t node);
/// `within_grasp`: only where the hand can take it back from where the agent stands.
Outcome place(WorldState& state, std::size_t target, bool inside, bool within_grasp = false);
Outcome swing(WorldState& state, std::size_t node, bool open);
Outcome switch_power(WorldState& state, std::size_t node, bool on);
Outcome slice(WorldState& state, std::size_t node);
/// The held thing falls from the hand and lies where it comes to rest.
Outcome drop(WorldState& state);
/// A step, a turn or a tilt of the camera (agent_moves.h).
Outcome move_body(WorldState& state, ActionType type);
Outcome reset_head(WorldState& state);
/// Moves or turns the hand that holds something; what it holds must meet nothing.
Outcome move_hand(WorldState& state, double ahead, double left);
Outcome rotate_hand(WorldState& state);
Outcome pour_to(WorldState& state, std::size_t target);
Outcome use_up(WorldState& state, std::size_t node);
Outcome wipe(WorldState& state, std::size_t node);
Outcome spread_to(WorldState& state, std::size_t node);
/// soak_with and the composite actions ..._with: the atomic steps they stand for, each with all its checks.
Outcome treat_with(WorldState& state, std::size_t tool, std::string_view effect);

/// sit_on and lie_on: `as` is SatOn or LainOn. The body stays at its place beside the seat and faces as the seat does.
Outcome take_seat(WorldState& state, std::size_t node, Predicate as);
Outcome stand_up(WorldState& state);
/// Why the body cannot walk or turn (it sits or lies), or nullopt.
std::optional<Outcome> keeps_seat(const WorldState& state, ActionType type);
Outcome plug(WorldState& state, std::size_t node, bool in);
Outcome fold(WorldState& state, std::size_t node);
Outcome break_apart(WorldState& state, std::size_t node);

/// What a tool does by itself to what lies in or on it, as things are now: effects whose needs are met. `tap_runs`:
/// water flows into it.
void run_processes(WorldState& state, std::size_t tool, bool tap_runs = false);

}  // namespace unietp
