#pragma once

#include <cstdint>

#include "simulation/paint.h"

namespace unietp {

/// What the floor and the walls of a room look like. It follows from the room's type, place and size, not from any
/// name: a home that is renamed looks the same. Kitchens and bathrooms have tiles (some kitchens boards), bathrooms
/// tiled walls, some bedrooms a carpet; all others have boards.
struct RoomPaint {
  enum class Floor : std::uint8_t { Checks, Tiles, Boards, Carpet };
  Floor floor = Floor::Boards;
  double unit_m = 0.16;                                           // side of a tile, width of a board
  bool turned = false;                                            // boards along y instead of x
  Color floor_color{190, 156, 116}, second_color{190, 156, 116};  // the second one of checks and of joints
  Color wall_color = kWallPaint;
  double tiled_m = 0;  // height up to which the walls have tiles
  std::uint32_t seed = 0;
};

/// nullptr: outside of all rooms, a plain gray floor.
RoomPaint room_paint(const Room* room);
/// Of a floor at a point of W that fills a pixel of this width.
Color floor_paint(const RoomPaint& room, const Vec2& at, double pixel_m);
/// Of a wall at a point of W: a baseboard, and a shade less light below the ceiling.
Color wall_paint(const RoomPaint& room, const Vec3& at, double wall_height_m, double pixel_m);

}  // namespace unietp
