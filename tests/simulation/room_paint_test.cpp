#include "simulation/room_paint.h"

#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace unietp {
namespace {

Room room(const std::string& id, const std::string& type, double x, double y, double width = 4, double depth = 3) {
  return {id, type, {{x, y}, {x + width, y}, {x + width, y + depth}, {x, y + depth}}};
}

std::tuple<double, double, double> rgb(const Color& color) { return {color.x(), color.y(), color.z()}; }

TEST(RoomPaint, OfARenamedRoomIsTheSame) {
  const Room one = room("bedroom_1", "bedroom", 3, 5), renamed = room("room|7", "bedroom", 3, 5);
  const RoomPaint a = room_paint(&one), b = room_paint(&renamed);
  for (int i = 0; i < 50; ++i) {
    const Vec2 at(3 + 0.07 * i, 5 + 0.05 * i);
    EXPECT_EQ(rgb(floor_paint(a, at, 0.002)), rgb(floor_paint(b, at, 0.002)));
    EXPECT_EQ(rgb(wall_paint(a, {at.x(), 5, 0.05 * i}, 2.6, 0.002)),
              rgb(wall_paint(b, {at.x(), 5, 0.05 * i}, 2.6, 0.002)));
  }
}

TEST(RoomPaint, DiffersBetweenTheRoomsOfAHome) {
  std::set<std::tuple<double, double, double>> floors, walls;
  for (int i = 0; i < 12; ++i) {
    const Room one = room("living_room_1", "living_room", 4.3 * i, 1.7 * i);
    floors.insert(rgb(room_paint(&one).floor_color));
    walls.insert(rgb(room_paint(&one).wall_color));
  }
  EXPECT_GE(floors.size(), 3U);
  EXPECT_GE(walls.size(), 4U);
}

TEST(RoomPaint, HasTilesInEveryBathroomAndNoneInBedrooms) {
  for (int i = 0; i < 40; ++i) {
    const Room bathroom = room("bathroom_1", "bathroom", 1.3 * i, 0.9 * i),
               bedroom = room("bedroom_1", "bedroom", 1.3 * i, 0.9 * i);
    const RoomPaint wet = room_paint(&bathroom), dry = room_paint(&bedroom);
    EXPECT_TRUE(wet.floor == RoomPaint::Floor::Tiles || wet.floor == RoomPaint::Floor::Checks);
    EXPECT_GT(wet.tiled_m, 1);
    EXPECT_TRUE(dry.floor == RoomPaint::Floor::Boards || dry.floor == RoomPaint::Floor::Carpet);
    EXPECT_EQ(dry.tiled_m, 0);
  }
}

TEST(RoomPaint, FadesJointsThatAreThinnerThanAPixel) {
  RoomPaint tiles;
  tiles.floor = RoomPaint::Floor::Tiles;
  tiles.unit_m = 0.3;
  tiles.floor_color = {200, 200, 200};
  tiles.second_color = {100, 100, 100};
  const auto red = [&](double pixel_m) { return floor_paint(tiles, {0.3, 0.15}, pixel_m).x(); };
  EXPECT_NEAR(red(0.001), 100, 1e-9) << "near, a joint has its own color";
  EXPECT_GT(red(0.06), 170) << "far away it is hardly seen";
  EXPECT_LT(red(0.06), 200);
}

}  // namespace
}  // namespace unietp
