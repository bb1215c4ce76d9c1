#include "simulation/room_paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/noise.h"

namespace unietp {
namespace {

using Rgb3 = std::array<double, 3>;
struct TwoColors {
  Rgb3 main, second;
};

constexpr std::array<TwoColors, 4> kTileColors{{{{204, 207, 208}, {186, 190, 192}},
                                                {{222, 216, 204}, {196, 188, 174}},
                                                {{196, 146, 116}, {170, 124, 98}},
                                                {{134, 140, 146}, {112, 118, 124}}}};
constexpr std::array<Rgb3, 5> kBoardColors{
    {{190, 156, 116}, {164, 122, 82}, {138, 98, 66}, {206, 180, 142}, {172, 160, 144}}};
constexpr std::array<Rgb3, 4> kCarpetColors{{{198, 186, 168}, {168, 168, 172}, {146, 160, 176}, {186, 160, 150}}};
constexpr std::array<Rgb3, 7> kWallColors{{{226, 221, 210},
                                           {234, 233, 229},
                                           {214, 216, 218},
                                           {208, 217, 205},
                                           {205, 215, 225},
                                           {230, 214, 190},
                                           {229, 210, 204}}};
constexpr std::array<Rgb3, 3> kWallTiles{{{232, 235, 236}, {214, 226, 230}, {230, 226, 214}}};
constexpr double kCarpets = 0.4, kKitchenBoards = 0.35, kCheckedFloors = 0.4;  // shares of the rooms of that kind

Color to_color(const Rgb3& rgb) { return {rgb[0], rgb[1], rgb[2]}; }

template <std::size_t N>
Color picked(const std::array<Rgb3, N>& colors, double share) {
  return to_color(colors[std::min(N - 1, static_cast<std::size_t>(share * N))]);
}

int cell_number(double way, double size) { return static_cast<int>(std::floor(way / size)); }

/// How much of a pixel around `way` a joint covers that lies at each multiple of `size`, 0 to 1: what is thinner than a
/// pixel is faint instead of broken.
double joint_share(double way, double size, double joint_m, double pixel_m) {
  const double rest = way - size * std::floor(way / size), distance = std::min(rest, size - rest);
  const double half = std::max(joint_m, pixel_m) / 2;
  return distance < half ? std::min(1.0, joint_m / pixel_m) : 0;
}

Color board_at(const RoomPaint& room, const Vec2& at, double pixel_m) {
  constexpr double kLong_m = 1.3, kJoint_m = 0.005, kShades = 0.12, kDark = 0.22;
  const double along = room.turned ? at.y() : at.x(), across = room.turned ? at.x() : at.y();
  const int row = cell_number(across, room.unit_m);
  const double shifted = along + kLong_m * hashed(row, 0, 0, room.seed);
  const double joint =
      std::max(joint_share(across, room.unit_m, kJoint_m, pixel_m), joint_share(shifted, kLong_m, kJoint_m, pixel_m));
  const double shade = hashed(row, cell_number(shifted, kLong_m), 1, room.seed);
  const double grain = noise({shifted * 3, across * 60, 0}, room.seed);
  return room.floor_color * (1 - kShades + kShades * (0.7 * shade + 0.3 * grain)) * (1 - kDark * joint);
}

Color tile_at(const RoomPaint& room, const Vec2& at, double pixel_m) {
  constexpr double kJoint_m = 0.006;
  const double joint = std::max(joint_share(at.x(), room.unit_m, kJoint_m, pixel_m),
                                joint_share(at.y(), room.unit_m, kJoint_m, pixel_m));
  const double shade = hashed(cell_number(at.x(), room.unit_m), cell_number(at.y(), room.unit_m), 0, room.seed);
  return room.floor_color * (0.97 + 0.03 * shade) * (1 - joint) + room.second_color * joint;
}

}  // namespace

RoomPaint room_paint(const Room* room) {
  RoomPaint paint;
  if (room == nullptr) {
    paint.floor = RoomPaint::Floor::Checks;
    paint.floor_color = paint.second_color = {150, 156, 150};
    return paint;
  }
  const Bounds bounds = room_bounds(*room, 1);
  const auto centimeters = [](double meters) { return static_cast<int>(std::lround(100 * meters)); };
  const Vec3 size = bounds.high - bounds.low;
  // Drawn from the corner and, apart from it, from the size; the order of draws is fixed.
  paint.seed = number_of(room->type) + static_cast<std::uint32_t>(centimeters(size.x()) * 131 + centimeters(size.y()));
  const auto draw = [&](int what) {
    return hashed(centimeters(bounds.low.x()), centimeters(bounds.low.y()), what, paint.seed);
  };
  const bool wet = room->type == "bathroom", kitchen = room->type == "kitchen";
  if (wet || (kitchen && draw(0) >= kKitchenBoards)) {
    const auto& colors = kTileColors[static_cast<std::size_t>(draw(1) * kTileColors.size())];
    paint.floor = draw(2) < kCheckedFloors ? RoomPaint::Floor::Checks : RoomPaint::Floor::Tiles;
    paint.unit_m = draw(3) < 0.5 ? 0.3 : 0.45;
    paint.floor_color = to_color(colors.main);
    paint.second_color = to_color(colors.second);
  } else if (room->type == "bedroom" && draw(0) < kCarpets) {
    paint.floor = RoomPaint::Floor::Carpet;
    paint.floor_color = picked(kCarpetColors, draw(1));
  } else {
    paint.floor_color = picked(kBoardColors, draw(1));
    paint.unit_m = draw(2) < 0.5 ? 0.12 : 0.18;
    paint.turned = draw(3) < 0.5;
  }
  paint.wall_color = picked(kWallColors, draw(4));
  if (wet) {
    paint.wall_color = picked(kWallTiles, draw(4));
    paint.tiled_m = draw(5) < 0.5 ? 1.2 : 2.0;
  }
  return paint;
}

Color floor_paint(const RoomPaint& room, const Vec2& at, double pixel_m) {
  switch (room.floor) {
    case RoomPaint::Floor::Checks: {
      const bool second = (cell_number(at.x(), room.unit_m) + cell_number(at.y(), room.unit_m)) % 2 != 0;
      return second ? room.second_color : room.floor_color;
    }
    case RoomPaint::Floor::Tiles:
      return tile_at(room, at, pixel_m);
    case RoomPaint::Floor::Carpet:
      return room.floor_color * (0.92 + 0.08 * rough_noise({40 * at.x(), 40 * at.y(), 0}, room.seed));
    case RoomPaint::Floor::Boards:
      break;
  }
  return board_at(room, at, pixel_m);
}

Color wall_paint(const RoomPaint& room, const Vec3& at, double wall_height_m, double pixel_m) {
  constexpr double kBoard_m = 0.09, kShade_m = 0.3, kTile_m = 0.2, kJoint_m = 0.006, kDark = 0.14;
  if (at.z() < room.tiled_m) {
    const double joint = std::max(joint_share(at.z(), kTile_m, kJoint_m, pixel_m),
                                  joint_share(at.x() + at.y(), kTile_m, kJoint_m, pixel_m));
    return room.wall_color * (1 - kDark * joint);
  }
  if (at.z() < kBoard_m) return {196, 190, 178};
  const Color plain = room.tiled_m > 0 ? kWallPaint : room.wall_color;
  return plain * (0.93 + 0.07 * std::clamp((wall_height_m - at.z()) / kShade_m, 0.0, 1.0));
}

}  // namespace unietp
