#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "simulation/footprint.h"
#include "simulation/navigation.h"
#include "simulation/physics.h"
#include "simulation/profile.h"

namespace unietp {

/// Distance from the agent's body axis (a vertical segment from the floor to the body's height at `at`) to the box of a
/// node, meters.
double reach_distance(const Node& node, const Vec2& at, const Profile& profile);

/// Target points of the rays that test whether a node is visible: the box's center and points inside each face and
/// corner, W.
std::vector<Vec3> sight_points(const Node& node);

/// True when a ray from the camera standing at `at` meets the node before anything else; `ignore` are bodies in the
/// agent's hands.
bool sees(const Node& thing, BodyId body, const PhysicsWorld& world, const Profile& profile, const Vec2& at,
          std::span<const BodyId> ignore = {});
/// The same for a node of a scene.
bool sees(const Scene& scene, const PhysicsWorld& world, const Profile& profile, const Vec2& at, std::size_t node,
          std::span<const BodyId> ignore = {});

/// Inputs of the search for a place to stand.
struct StandingInputs {
  const Node& target;
  const Shape& shape;  // its own
  const NavigationGrid& grid;
  const CellSet& walk;  // the cells that the body can walk to
  const Profile& profile;
};

/// The cells that the body can walk to from which a node is in reach, and, when it can be opened, outside of the sweep
/// of its door; the best first: nearest to the front and to the object. Visibility is not included, since it changes
/// with every object that is moved.
class StandingCells {
 public:
  /// The center of the k-th best cell, or nullptr when there are fewer; valid until the next call. All calls must pass
  /// the same inputs.
  const Vec2* best(std::size_t k, const StandingInputs& asked);

 private:
  struct Candidate {
    double cost;
    NavigationGrid::Cell cell;
    Vec2 at;
    bool operator>(const Candidate& other) const;
  };
  void look_farther(const StandingInputs& asked, double limit_m);

  std::vector<FloorFootprint> way_;  // of the door
  double looked_m_ = -1;             // distance from the node up to which all cells were examined
  std::vector<Candidate> open_;      // a heap, since mostly one of the first few is taken
  std::vector<Vec2> best_;           // removed from the heap, in order
};

/// A place to stand from which the node is in reach and in sight: the best of the first 80 cells; nullopt when there is
/// none. The cells must be the node's, as it is now.
std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, std::size_t node,
                                   const StandingInputs& asked, StandingCells& cells);
/// The same without cached cells.
std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, const NavigationGrid& grid,
                                   const CellSet& walk_from_agent, const Profile& profile, std::size_t node);

}  // namespace unietp
