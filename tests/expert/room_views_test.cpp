// Which parts of rooms an agent has looked at, and where it turns next.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "expert/room_views.h"

namespace unietp::testing {
namespace {

Profile square_picture() {
  Profile profile;
  profile.vertical_fov_deg = 90;
  profile.image_width = profile.image_height = 300;
  profile.turn_deg = 30;
  return profile;
}

Scene two_rooms() {
  Scene scene;
  scene.rooms.push_back({"kitchen_1", "kitchen", {{0, 0}, {6, 0}, {6, 6}, {0, 6}}});
  scene.rooms.push_back({"bedroom_1", "bedroom", {{6, 0}, {9, 0}, {9, 3}, {6, 3}}});
  return scene;
}

Agent at(double x, double y, double yaw) {
  Agent agent;
  agent.position = {x, y};
  agent.yaw = yaw;
  return agent;
}

TEST(RoomViews, CountWhatWasBetweenTheEdgesOfThePictureInTheSameRoom) {
  const Scene home = two_rooms();
  RoomViews views(home, square_picture());
  EXPECT_EQ(views.unseen(0), 1);
  views.saw(at(3, 3, 0));  // a quarter of the room, and the bedroom through the wall
  EXPECT_NEAR(views.unseen(0), 0.75, 0.1);
  EXPECT_EQ(views.unseen(1), 1);
  views.saw(at(3, 3, std::numbers::pi));
  EXPECT_NEAR(views.unseen(0), 0.5, 0.2);
  views.saw(at(3, 3, std::numbers::pi / 2));
  views.saw(at(3, 3, -std::numbers::pi / 2));
  EXPECT_EQ(views.unseen(0), 0);
  EXPECT_FALSE(views.best(0, at(3, 3, 0)));
}

TEST(RoomViews, TurnToTheSideThatShowsMore) {
  const Scene home = two_rooms();
  RoomViews views(home, square_picture());
  const Agent corner = at(0.4, 0.4, -std::numbers::pi / 4);  // the room is to the left
  views.saw(corner);
  const auto left = views.best(0, corner);
  ASSERT_TRUE(left);
  EXPECT_FALSE(left->goes);
  EXPECT_GT(left->turns, 0);
  const auto right = views.best(0, at(0.4, 5.6, std::numbers::pi / 4));
  ASSERT_TRUE(right);
  EXPECT_LT(right->turns, 0);
  EXPECT_EQ(right->steps(), -right->turns);
}

TEST(RoomViews, GoIntoARoomThatTheAgentIsNotIn) {
  const Scene home = two_rooms();
  const RoomViews views(home, square_picture());
  const auto look = views.best(1, at(3, 3, 0));
  ASSERT_TRUE(look);
  EXPECT_TRUE(look->goes);
  EXPECT_EQ(look->turns, 0) << "the first view after a step";
  EXPECT_EQ(look->steps(), 1);
  EXPECT_GT(look->shows, 0);
}

TEST(RoomViews, GoOnceToARoomWhoseMiddleIsTaken) {
  const Scene home = two_rooms();
  RoomViews views(home, square_picture());
  const Vec2 beside(4.4, 4.4);  // where going to the first room leads: not to its middle
  Agent agent = at(0.4, 0.4, 0);
  int gone = 0, looks = 0;
  for (auto look = views.best(0, agent); look && looks < 30; look = views.best(0, agent), ++looks) {
    if (look->goes) {
      ++gone;
      agent.position = beside;
      views.arrived(0, beside);
    }
    agent.yaw += look->turns * std::numbers::pi / 6;
    views.saw(agent);
  }
  EXPECT_LE(gone, 1);
  EXPECT_LT(looks, 12);
  EXPECT_EQ(views.unseen(0), 0);
}

}  // namespace
}  // namespace unietp::testing
