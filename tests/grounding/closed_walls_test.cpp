// Nothing can be seen through: what shows in a picture from the middle of a room lies within the home.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "homes.h"
#include "simulation/channels.h"

namespace unietp {
namespace {

constexpr double kWall_m = 0.15;  // beyond a room's polygon: the wall's thickness
constexpr int kPixels = 120;      // each way, of 90 degrees

/// Square pictures of all that is around a point: level, up to the ceiling and down to the floor.
std::vector<Camera> cameras_at(const Vec3& at) {
  std::vector<Camera> cameras;
  for (int turn = 0; turn < 4; ++turn) {
    for (const double tilt : {-0.7, 0.0, 0.7}) {
      const double yaw = turn * std::numbers::pi / 2;
      const Vec3 level(std::cos(yaw), std::sin(yaw), 0);
      Camera camera;
      camera.at = at;
      camera.ahead = std::cos(tilt) * level - std::sin(tilt) * Vec3::UnitZ();
      camera.right = level.cross(Vec3::UnitZ());
      camera.down = camera.ahead.cross(camera.right);
      camera.width = camera.height = kPixels;
      camera.focal = kPixels / 2.0;
      cameras.push_back(camera);
    }
  }
  return cameras;
}

bool is_in_the_home(const Scene& scene, const Vec2& point) {
  return std::any_of(scene.rooms.begin(), scene.rooms.end(), [&](const Room& room) {
    const Bounds bounds = room_bounds(room, scene.wall_height);
    return (point - bounds.low.head<2>()).minCoeff() > -kWall_m &&
           (bounds.high.head<2>() - point).minCoeff() > -kWall_m;
  });
}

/// Pixels of pictures from the middles of the first rooms that show something outside of the home, or nothing.
int pixels_outside(const Scene& scene, std::size_t rooms) {
  int outside = 0;
  for (std::size_t room = 0; room < std::min(rooms, scene.rooms.size()); ++room) {
    const Bounds bounds = room_bounds(scene.rooms[room], scene.wall_height);
    Vec3 at = (bounds.low + bounds.high) / 2;
    at.z() = 1.6;
    for (const Camera& camera : cameras_at(at)) {
      const Channels seen = channels_of(scene, camera);
      for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
          const double depth = seen.depth[static_cast<std::size_t>(y * camera.width + x)];
          const Vec3 point = camera.at + std::min(depth, 1000.0) * camera.ray(x + 0.5, y + 0.5);
          outside += is_in_the_home(scene, point.head<2>()) ? 0 : 1;
        }
      }
    }
  }
  return outside;
}

class ClosedWalls : public ::testing::TestWithParam<Simulator> {};

TEST_P(ClosedWalls, LetNothingOutsideOfTheHomeBeSeen) {
  const auto style = style_of(GetParam());
  ASSERT_TRUE(style);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    auto home = full_home_of(*style, seed);
    ASSERT_TRUE(home) << format(home.error());
    EXPECT_EQ(pixels_outside(*home, home->rooms.size()), 0) << seed;
    ASSERT_FALSE(home->openings.empty());
    // Through a doorway that leads out of the home something is seen, if this sees anything.
    const Opening& way = home->openings.front();
    const std::string gone = home->rooms.front().id == way.room_a ? way.room_b : way.room_a;
    const auto is_gone = [&](const Room& room) { return room.id == gone; };
    const Room lost = *std::find_if(home->rooms.begin(), home->rooms.end(), is_gone);
    home->rooms.erase(std::find_if(home->rooms.begin(), home->rooms.end(), is_gone));
    erase_if(home->nodes, [&](const Node& node) { return contains(lost.polygon, node.pose.position.head<2>()); });
    EXPECT_GT(pixels_outside(*home, home->rooms.size()), 0) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Simulators, ClosedWalls, ::testing::ValuesIn(kSimulators),
                         [](const auto& one) { return std::string(name_of(one.param)); });

}  // namespace
}  // namespace unietp
