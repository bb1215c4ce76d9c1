#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "simulation/navigation.h"
#include "simulation/physics.h"
#include "simulation/profile.h"
#include "simulation/shadow.h"

namespace unietp {

/// Distance from the agent's body axis (a vertical segment from the floor to the body's height at `at`) to the box of a
/// node, metres.
double reach_distance(const Node& node, const Vec2& at, const Profile& profile);

/// Points that rays go to when it is asked whether a node can be seen: the box's centre, one inside each face and each
/// corner, W.
std::vector<Vec3> sight_points(const Node& node);

/// True when a ray from the camera standing at `at` meets the node before anything else; `ignore` are bodies in the
/// agent's hands.
bool sees(const Node& thing, BodyId body, const PhysicsWorld& world, const Profile& profile, const Vec2& at,
          std::span<const BodyId> ignore = {});
bool sees(const Scene& scene, const PhysicsWorld& world, const Profile& profile, const Vec2& at, std::size_t node,
          std::span<const BodyId> ignore = {});

/// What decides where one can stand to reach a node.
struct StandingQuestion {
  const Node& target;
  const Shape& shape;  // its own
  const NavigationGrid& grid;
  const CellSet& walk;  // the cells that the body can walk to
  const Profile& profile;
};

/// The cells that the body can walk to from which a node is in reach, and, when it can be opened, out of its door's
/// way; the best first: nearest to the front and to the object. What can be seen from them is another question, whose
/// answer changes with every thing that is moved.
class StandingCells {
 public:
  /// The middle of the k-th best cell, or nullptr when there are not so many; valid until the next call. All calls ask
  /// the same.
  const Vec2* best(std::size_t k, const StandingQuestion& asked);

 private:
  struct Candidate {
    double cost;
    NavigationGrid::Cell cell;
    Vec2 at;
    bool operator>(const Candidate& other) const;
  };
  void look_farther(const StandingQuestion& asked, double limit_m);

  std::vector<Shadow> way_;      // of the door
  double looked_m_ = -1;         // how far from the node all cells have been looked at
  std::vector<Candidate> open_;  // a heap: one of the first few mostly does, so the others need no order
  std::vector<Vec2> best_;       // those that left it
};

/// A place to stand from which the node is in reach and in sight: the best of the first 80 cells; nullopt when there is
/// none. The cells must be the node's, as it is now.
std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, std::size_t node,
                                   const StandingQuestion& asked, StandingCells& cells);
std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, const NavigationGrid& grid,
                                   const CellSet& walk_from_agent, const Profile& profile, std::size_t node);

}  // namespace unietp
