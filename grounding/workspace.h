#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "akb/knowledge.h"
#include "core/result.h"
#include "core/rng.h"
#include "grounding/collision.h"
#include "scene/scene.h"
#include "simulation/physics.h"

namespace unietp {

/// A scene at work: the graph with its solids for physics and for FCL, kept in step. Node i is body i in both.
class Workspace {
 public:
  Workspace(Scene scene, const Knowledge& knowledge);

  const Scene& scene() const { return scene_; }
  const Knowledge& knowledge() const { return *knowledge_; }
  PhysicsWorld& physics() { return physics_; }
  const PhysicsWorld& physics() const { return physics_; }
  const PlacementChecker& checker() const { return checker_; }

  /// Appends a node where its pose says; gives its index.
  std::size_t add(Node node);
  /// Replaces a node and moves its solids along.
  void replace(std::size_t index, Node node);
  /// Takes a node out. Indices above it sink by one.
  void remove(std::size_t index);
  /// Reads the edges anew from physics.
  void read_edges();
  Scene take() && { return std::move(scene_); }
  Agent& agent() { return scene_.agent; }

  /// The space that the doors and drawers of furniture pass through, by node; empty bounds for nodes without.
  const std::vector<std::optional<Bounds>>& sweeps() const { return sweeps_; }
  /// The bounds of each node where it stands, by node.
  const std::vector<Bounds>& bounds() const { return bounds_; }
  std::string name_of(BodyId body) const;  // node's id, "wall" or "floor"

 private:
  void rebuild();

  Scene scene_;
  const Knowledge* knowledge_;
  PhysicsWorld physics_;
  PlacementChecker checker_;
  std::vector<std::optional<Bounds>> sweeps_;
  std::vector<Bounds> bounds_;
};

/// The space that a node's moving parts pass through when it is opened, in W; nullopt when nothing moves.
std::optional<Bounds> sweep_of(const Node& node);

/// A relation that the knowledge allows between two categories; `on` and `inside` only.
bool allowed(const Knowledge& knowledge, const Node& object, Predicate relation, const Node& receptacle);

}  // namespace unietp
