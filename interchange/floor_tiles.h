#pragma once

#include <optional>
#include <vector>

#include "scene/geometry.h"
#include "scene/scene.h"

namespace unietp {

/// A level rectangle along the axes, meters.
struct Tile {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};

/// Sets coordinates of all tiles that are within `gap_m` of each other to one value, so that rooms side by side share
/// the line of their wall. Coordinates that stand alone keep their value.
void align(const std::vector<Tile*>& tiles, double gap_m);

/// The outline of what the tiles cover without the holes, counter-clockwise; nothing when that is not one piece without
/// holes.
std::optional<std::vector<Vec2>> outline_of(const std::vector<Tile>& tiles, const std::vector<Tile>& holes = {});
/// The rectangle around all tiles; at least one.
Tile bounds_of(const std::vector<Tile>& tiles);
/// Counter-clockwise from the lower left one.
std::vector<Vec2> corners_of(const Tile& tile);

/// Rectangles that cover the polygon and nothing else; empty when a side is not along an axis.
std::vector<Tile> tiles_of(const std::vector<Vec2>& polygon);

/// The gap in the wall of `room` nearest to a doorway's box, as wide as the box is along that wall.
/// `low`, `high`: the box in W. Ids and height are left to the caller.
Opening opening_in(const std::vector<Vec2>& polygon, const Tile& doorway);

}  // namespace unietp
