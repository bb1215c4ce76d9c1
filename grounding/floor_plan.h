#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rng.h"
#include "scene/scene.h"

namespace unietp {

/// Width of the openings between rooms.
inline constexpr double kOpeningWidth_m = 1.0;

/// Rooms and the openings between them.
struct FloorPlan {
  std::vector<Room> rooms;
  std::vector<Opening> openings;
};

/// The passage of a room that nobody walks through.
inline constexpr int kNoPassage = 5;

/// A room that a plan shall have.
struct RoomRequest {
  std::string type;
  double area_m2 = 0;  // met within a sixth or so
  int passage = 3;     // from 0, a corridor, to kNoPassage: the higher, the less people like to walk through it
};

/// Stage: requests → rooms that share walls and do not overlap, joined by openings so that all hang together. Two kinds
/// of plan: a rectangle cut in two again and again, at times with a piece cut off, and, where a corridor is requested,
/// two rows of rooms along it, of which one may be shorter. Openings: a spanning tree that prefers rooms of a low
/// passage and goes through none of kNoPassage; a few more between rooms that people pass through. Rooms come in the
/// order of the requests, axis-parallel rectangles with corners at whole decimetres; ids are type_1, type_2, …. nullopt
/// when this draw gives a room that is too narrow or cannot be joined so. Deterministic in rng.
std::optional<FloorPlan> draw_floor_plan(const std::vector<RoomRequest>& requests, Rng rng);

/// A part of a room's wall, seen from inside: side 0 is the wall at the low y, 1 at the high x, 2 at the high y, 3 at
/// the low x; from and to along it, W.
struct WallStretch {
  int side = 0;
  double from = 0, to = 0;
};
/// The parts of a rectangular room's walls that have no other room behind them.
std::vector<WallStretch> outer_walls(const Scene& scene, std::size_t room);

}  // namespace unietp
