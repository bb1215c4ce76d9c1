#pragma once

#include <optional>
#include <vector>

#include "grounding/failure.h"
#include "logic/formula.h"
#include "logic/trace.h"
#include "scene/node_index.h"
#include "scene/scene.h"
#include "simulation/walk.h"

namespace unietp {

/// Ways on foot from one point of a room, over cells of the room that the agent can walk to: steps to the eight
/// neighbors, slantwise only where both cells beside the step are such cells.
class RoomWalk {
 public:
  RoomWalk(const Walk& walk, const Room& room, const Vec2& from);

  /// Meters to another point: from the cell of the room nearest to the one to that nearest to the other, and from there
  /// to the points. nullopt when there is no way within the room.
  std::optional<double> meters_to(const Vec2& point) const;

 private:
  using Cell = NavigationGrid::Cell;
  bool is_of_room(Cell cell) const;
  std::size_t place(Cell cell) const { return static_cast<std::size_t>(cell.y - low_.y) * width_ + column(cell); }
  std::size_t column(Cell cell) const { return static_cast<std::size_t>(cell.x - low_.x); }
  std::optional<Cell> nearest(const Vec2& point) const;
  void spread(Cell from);

  const NavigationGrid& grid_;
  Cell low_, high_;  // of the room's bounds, both included
  std::size_t width_ = 0;
  std::vector<bool> of_room_;   // by place
  std::vector<double> meters_;  // from the first cell
  double before_ = 0;           // from the point to the first cell
};

/// What a goal calls the nearest to something is so on foot, too, by the margins of `nearest`, along ways within the
/// landmark's room: each referent is the nearest to one of the landmarks among those of its category in that room, and
/// none that the goal does not mean is. `walk`: of the scene; `trace`: its first state is read. The first reference
/// that is not so (`odd-reference`), or nullopt.
std::optional<GroundingFailure> check_nearness_on_foot(const Formula& goal, const Scene& scene, const NodeIndex& places,
                                                       const Trace& trace, const Walk& walk);

}  // namespace unietp
