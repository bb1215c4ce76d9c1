#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "simulation/navigation.h"

namespace unietp {

/// How far it is on foot from one place in a room to others in it, over the floor that the agent can walk to. Steps go
/// to the eight neighboring cells, slantwise only where both cells beside the step are floor, too. Takes time in
/// proportion to the room. Written apart from grounding/, which measures the same.
class RoomWays {
 public:
  RoomWays(const NavigationGrid& grid, const CellSet& reached, const Room& room, const Vec2& from);

  /// Meters to a point, from each end to the nearest cell of the floor (of equally near ones the first by row, then
  /// column) and between these; nullopt when there is no way within the room.
  std::optional<double> meters(const Vec2& to) const;

 private:
  static constexpr double kNoWay = std::numeric_limits<double>::infinity();

  std::optional<std::size_t> nearest(const Vec2& point) const;
  void walk(std::size_t first);

  Vec2 from_;
  int width_ = 0, height_ = 0;  // of the part of the grid around the room
  std::vector<bool> floor_;     // by row and column
  std::vector<Vec2> centers_;
  std::vector<double> ways_;  // meters between the middles of cells
  std::optional<std::size_t> first_;
};

}  // namespace unietp
