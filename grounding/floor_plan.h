#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rng.h"
#include "grounding/room_doors.h"
#include "scene/scene.h"

namespace unietp {

/// Width of the openings between rooms.
inline constexpr double kOpeningWidth_m = 1.0;

/// Rooms and the openings between them.
struct FloorPlan {
  std::vector<Room> rooms;
  std::vector<Opening> openings;
};

/// A room that a plan shall have.
struct RoomRequest {
  std::string type;
  double area_m2 = 0;  // met within a sixth or so; a corridor gets the length and width that its plan needs
};

/// Stage: requests → rooms that share walls and do not overlap, joined by openings as choose_openings says. With a
/// corridor among them three kinds of plan: two rows of rooms along it, of which one may be shorter; kitchen, dining
/// and living room across the whole depth at one end of a shorter one; seldom a rectangle cut in two again and again,
/// at times with a piece cut off, which is also the kind without a corridor. The first request is the room that one
/// enters the home by: it has an outer wall. Rooms come in the order of the requests, axis-parallel rectangles with
/// corners at whole decimeters; ids are type_1, type_2, …. nullopt when this draw gives a room that is too narrow or
/// cannot be joined so. Deterministic in rng.
std::optional<FloorPlan> draw_floor_plan(const std::vector<RoomRequest>& requests, const RoomDoors& doors, Rng rng);

/// A part of a room's wall, seen from inside: side 0 is the wall at the low y, 1 at the high x, 2 at the high y, 3 at
/// the low x; from and to along it, W.
struct WallStretch {
  int side = 0;
  double from = 0, to = 0;
};
/// The parts of a rectangular room's walls that have no other room behind them.
std::vector<WallStretch> outer_walls(const std::vector<Room>& rooms, std::size_t room);

/// Where one comes in.
struct Entrance {
  Vec2 at = Vec2::Zero();      // in the middle of the front door, on the first room's polygon
  Vec2 inward = Vec2::Zero();  // unit vector away from the wall
};
/// Of a home of rectangular rooms: in an outer wall of the first room, of the shortest walls that have room for a door,
/// so at the end of a corridor. nullopt when none has.
std::optional<Entrance> entrance_of(const std::vector<Room>& rooms);

}  // namespace unietp
