#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "simulation/physics.h"
#include "simulation/profile.h"

namespace unietp {

/// A solid seen from above: a rectangle turned by its yaw, or its bounds when it does not stand upright.
struct Shadow {
  Vec2 centre = Vec2::Zero(), along = Vec2::UnitX(), half = Vec2::Zero();  // `along`: unit, the rectangle's own x
  bool operator==(const Shadow& other) const {
    return centre == other.centre && along == other.along && half == other.half;
  }
};

/// Where a body of the profile's radius can stand: a grid of kCell_m over the rooms' bounds. A cell is free when a disc
/// of the body's radius around its centre meets no wall and no solid between 5 cm and the body's height.
class NavigationGrid {
 public:
  static constexpr double kCell_m = 0.1;
  struct Cell {
    std::int32_t x = 0, y = 0;
    bool operator==(const Cell&) const = default;
  };

  NavigationGrid(const Scene& scene, const Profile& profile);
  /// Node i is now as given, with that shape; or, with nullptr, no longer there. The same as a new grid.
  void update(std::size_t i, const Node* node, const Shape* shape);
  /// Another number whenever the free cells may be others.
  std::uint64_t version() const { return version_; }

  bool free(Cell cell) const;
  Cell cell_at(const Vec2& point) const;
  Vec2 centre(Cell cell) const;
  int width() const { return width_; }
  int height() const { return height_; }

  /// Position of a cell in `distances`: row-major, width() per row. The cell must lie in the grid.
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(cell.x);
  }

  /// Steps (4-connected cells) from `from` to every cell; -1 where it cannot walk. By `index`.
  std::vector<std::int32_t> distances(Cell from) const;
  /// The free cell nearest to a point, ties by row then column.
  std::optional<Cell> nearest_free(const Vec2& point) const;
  /// Cells of a shortest walk, both ends included; empty when there is none.
  std::vector<Cell> path(Cell from, Cell to) const;
  /// A walk as a person would draw it: the shortest path pulled straight wherever a straight line stays on free cells.
  /// Both points included; empty when there is no way.
  std::vector<Vec2> walk(const Vec2& from, const Vec2& to) const;

 private:
  void count(const Shadow& shadow, int by);
  int width_ = 0, height_ = 0;
  Vec2 origin_ = Vec2::Zero();
  double body_radius_ = 0, body_height_ = 0;
  std::vector<std::uint16_t> blockers_;       // by cell: solids over it, and 1 outside of all rooms
  std::vector<std::vector<Shadow>> shadows_;  // by node: what of it is counted
  std::uint64_t version_ = 0;
};

/// Distance from the agent's body axis (a vertical segment from the floor to the body's height at `at`) to the box of a
/// node, metres.
double reach_distance(const Node& node, const Vec2& at, const Profile& profile);

/// Whether a movable thing with these bounds is in the way of walking: it is on or near the floor.
bool stands_low(const Bounds& bounds);

/// True when a body standing at `at` would be hit by the node's door, lid or drawer somewhere on its way.
bool in_door_way(const Node& node, const Vec2& at, const Profile& profile);

/// Points that rays go to when it is asked whether a node can be seen: the box's centre, one inside each face and each
/// corner, W.
std::vector<Vec3> sight_points(const Node& node);

/// True when a ray from the camera standing at `at` meets the node before anything else; `ignore` are bodies in the
/// agent's hands.
bool sees(const Node& thing, BodyId body, const PhysicsWorld& world, const Profile& profile, const Vec2& at,
          std::span<const BodyId> ignore = {});
bool sees(const Scene& scene, const PhysicsWorld& world, const Profile& profile, const Vec2& at, std::size_t node,
          std::span<const BodyId> ignore = {});

/// A place to stand from which the node is in reach and in sight and, when it can be opened, out of its door's way:
/// the best (nearest to the front and to the object) among the cells that the body can walk to from `start`; nullopt
/// when there is none.
std::optional<Vec2> standing_place(const Scene& scene, const PhysicsWorld& world, const NavigationGrid& grid,
                                   const std::vector<std::int32_t>& walk_from_agent, const Profile& profile,
                                   std::size_t node, std::span<const BodyId> ignore = {});

}  // namespace unietp
