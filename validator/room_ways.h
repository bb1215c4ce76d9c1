#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "simulation/navigation.h"

namespace unietp {

/// The floor of one room that the agent can walk to, and how far it is from place to place there. Steps go to the eight
/// neighboring cells, slantwise only where both cells beside the step are floor, too. Written apart from grounding/,
/// which measures the same.
class RoomWays {
 public:
  RoomWays(const NavigationGrid& grid, const CellSet& reached, const Room& room);

  /// Meters between two points, from each to the nearest cell of the floor (of equally near ones the first by row, then
  /// column) and between these; nullopt when there is no way within the room.
  std::optional<double> meters(const Vec2& from, const Vec2& to) const;

 private:
  std::optional<std::size_t> nearest(const Vec2& point) const;
  void sweep(std::vector<double>& ways, bool forward, bool& changed) const;
  double through(const std::vector<double>& ways, std::size_t i) const;

  int width_ = 0, height_ = 0;  // of the whole grid
  std::vector<bool> floor_;     // by row and column
  std::vector<Vec2> centres_;
};

}  // namespace unietp
