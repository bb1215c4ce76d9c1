#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "grounding/collision.h"
#include "grounding/current_state.h"
#include "grounding/home.h"
#include "grounding/household.h"
#include "scene/scene.h"
#include "simulation/physics.h"

namespace unietp {

/// A scene at work: the graph with its solids for physics and for FCL, kept in step. Node i is body i in both.
class Workspace {
 public:
  Workspace(Scene scene, const Knowledge& knowledge);
  /// Begins as a home, of which it takes over what does not change. The home must outlive it.
  Workspace(const Home& home, const Knowledge& knowledge);

  /// The scene; of a home's, without its edges.
  const Scene& scene() const { return scene_; }
  /// The knowledge base, and the solids for physics and for placement.
  const Knowledge& knowledge() const { return *knowledge_; }
  PhysicsWorld& physics() { return physics_; }
  const PhysicsWorld& physics() const { return physics_; }
  const PlacementChecker& checker() const { return checker_; }
  /// How things are in such a home; nullptr when nothing is known of that. It must outlive this value.
  const Household* household() const { return household_; }
  void set_household(const Household* household) { household_ = household; }
  const Home* home() const { return home_; }  // nullptr for a scene of its own

  /// Appends a node where its pose says; gives its index.
  std::size_t add(Node node);
  /// Replaces a node and moves its solids along.
  void replace(std::size_t index, Node node);
  /// Takes a node out; the last one gets its place.
  void remove(std::size_t index);
  /// Reads the relations anew from physics: the scene's edges; of a home only what can have changed, for `present`.
  void read_edges();
  /// The state of a workspace that began as a home, as last read.
  const CurrentState& current_state() const { return *current_state_; }
  /// Of such a one: where a body can stand, and where it can walk, as home.h says.
  std::optional<NavigationGrid> other_grid() const { return unietp::other_grid(*home_, scene_, moved_); }
  std::shared_ptr<const Walk> walk() const { return walk_of(*home_, scene_, moved_); }
  /// Of such a one: ids of everything that rests on or in a thing, directly or through others, in scene order, as last
  /// read.
  std::vector<std::string> carried_by(std::size_t index) const;
  /// Another number after each reading.
  int reading() const { return reading_; }
  /// How the scene differs from the home that it began as, as last read: changes_of the two, at the cost of what was
  /// touched.
  Delta changes() const;
  /// The scene of a workspace of its own.
  Scene take() && { return std::move(scene_); }
  /// To be moved; the agent has no solid here.
  Agent& agent() { return scene_.agent; }

  /// The space that the doors and drawers of furniture pass through, by node; empty bounds for nodes without.
  const SharedList<std::optional<Bounds>>& sweeps() const { return sweeps_; }
  /// No such space goes farther than this beyond the bounds of its node, m.
  double farthest_sweep() const { return farthest_sweep_; }
  /// The bounds of each node where it stands, by node.
  const SharedList<Bounds>& bounds() const { return bounds_; }
  /// Where things stand in the scene's list. A trial is not in it.
  const NodeIndex& places() const { return places_; }
  /// The room around the middle of a node, nullptr for none.
  const Room* room_of(std::size_t index) const;
  /// Whether that room is one of these, one bool a room of the scene.
  bool is_in(std::size_t index, const std::vector<bool>& rooms) const {
    return rooms_[index] >= 0 && rooms[static_cast<std::size_t>(rooms_[index])];
  }
  /// The rooms of which the type meets the test, one bool a room.
  template <class Test>
  std::vector<bool> rooms_with(const Test& type) const {
    std::vector<bool> with;
    for (const Room& room : scene_.rooms) with.push_back(type(room.type));
    return with;
  }
  /// The nodes with their middle in a room, ascending.
  std::vector<std::size_t> nodes_in(std::size_t room) const;
  /// The same of several rooms; the last of `rooms` says of those in no room.
  std::vector<std::size_t> nodes_in(const std::vector<bool>& rooms) const;
  std::string name_of(BodyId body) const;  // node's id, "wall" or "floor"

 private:
  friend class TrialNode;
  void place(std::size_t index, Node node);
  void note(std::size_t index);

  Scene scene_;
  const Knowledge* knowledge_;
  const Household* household_ = nullptr;
  const Home* home_ = nullptr;
  PhysicsWorld physics_;
  PlacementChecker checker_;
  SharedList<std::optional<Bounds>> sweeps_;
  double farthest_sweep_ = 0;
  SharedList<Bounds> bounds_;
  NodeIndex places_;
  std::vector<std::int32_t> rooms_;            // by node: place of its room, -1 for none
  std::vector<std::size_t> moved_;             // where in the list another body was set, or none is left
  std::optional<CurrentState> current_state_;  // when it began as a home
  int reading_ = 0;
};

/// While it lives, a node stands in the graph and in physics, but not in FCL, in place of the one at `index` or as one
/// more after the last: a trial. The workspace is as before afterwards; references to nodes do not survive it.
class TrialNode {
 public:
  TrialNode(Workspace& workspace, Node node, std::size_t index);
  ~TrialNode();
  TrialNode(const TrialNode&) = delete;
  TrialNode& operator=(const TrialNode&) = delete;

  void move(const Pose& pose);                          // to another place
  const Shape& shape() const { return shape_; }         // of the object, in its own frame
  BodyId body() const { return BodyId::node(index_); }  // in the physics world

 private:
  Workspace& workspace_;
  std::size_t index_;
  Shape shape_;
  std::optional<Node> before_;
};

/// A relation that the knowledge allows between two categories; `on` and `inside` only.
bool allowed(const Knowledge& knowledge, const Node& object, Predicate relation, const Node& receptacle);

}  // namespace unietp
