// What a view leaves out before it looks, and what boxes mean in it.
#include <numbers>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "simulation/view.h"
#include "simulation/wall_shadow.h"
#include "tests/simulation/by_rays.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

/// Whether a ray from the eye to a point passes through the wall.
bool crosses(const WallPiece& wall, const Vec3& eye, const Vec3& point) {
  const Eigen::Matrix3d own = wall.pose.rotation.toRotationMatrix().transpose();
  const Vec3 from = own * (eye - wall.pose.position), to = own * (point - wall.pose.position);
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double way = to[axis] - from[axis];
    const double one = (-wall.size[axis] / 2 - from[axis]) / way, other = (wall.size[axis] / 2 - from[axis]) / way;
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  return enter <= leave;
}

TEST(WallShadow, HidesOnlySpheresOfWhichEveryPointIsBehindTheWall) {
  Rng rng(3);
  int hidden = 0, in_sight = 0;
  for (int i = 0; i < 20000; ++i) {
    WallPiece wall{{{0, 0, 1.2}, Eigen::Quaterniond(Eigen::AngleAxisd(6.28 * rng.unit(), Vec3::UnitZ()))},
                   {rng.uniform(0.05, 3), 0.1, 2.4}};
    if (rng.chance(0.5)) std::swap(wall.size.x(), wall.size.y());
    const Vec3 eye(rng.uniform(-3, 3), rng.uniform(-3, 3), 1.5);
    const auto shadow = WallShadow::of(wall, eye);
    if (!shadow) continue;
    const Vec3 center(rng.uniform(-4, 4), rng.uniform(-4, 4), rng.uniform(0, 2.4));
    const double radius = rng.uniform(0.02, 0.5);
    if (!shadow->hides(center, radius)) {
      ++in_sight;
      continue;
    }
    ++hidden;
    for (int k = 0; k < 20; ++k) {
      const Vec3 aside(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1));
      ASSERT_TRUE(crosses(wall, eye, center + radius * aside.normalized()));
    }
  }
  EXPECT_GT(hidden, 500);
  EXPECT_GT(in_sight, 500);
}

TEST(WallShadow, IsBehindTheMiddleOfAWallAndNotBesideOrBeforeIt) {
  const WallPiece wall{{{0, 0, 1}, Eigen::Quaterniond::Identity()}, {2, 0.1, 2}};
  const auto shadow = WallShadow::of(wall, {0, -1, 1});
  ASSERT_TRUE(shadow);
  EXPECT_TRUE(shadow->hides({0, 1, 1}, 0.3));
  EXPECT_FALSE(shadow->hides({0, -0.5, 1}, 0.3)) << "before it";
  EXPECT_FALSE(shadow->hides({1.1, 0.1, 1}, 0.3)) << "half beside it";
  EXPECT_FALSE(WallShadow::of(wall, {3, 0, 1})) << "who looks along it is before none of its faces";
}

/// Two bars that cross before the camera have the same box; the one with the lesser id is meant by it.
TEST(Viewer, FindsTheFirstOfThoseWithTheSameBox) {
  const Profile profile = *load_profile(UNIETP_SOURCE_DIR "/data/simulators", Simulator::Ai2thor);
  Scene scene = testing::wide_kitchen(Simulator::Ai2thor);
  scene.nodes = {};
  scene.agent.position = {1.5, 2};
  scene.agent.yaw = scene.agent.pitch = 0;
  for (const auto& [id, turn] : {std::pair("bar_b", 1.0), std::pair("bar_a", -1.0), std::pair("bar_c", 0.0)}) {
    Node bar;
    bar.id = id;
    bar.category = "Bar";
    bar.archetype = Archetype::Box;
    bar.size = {0.02, 0.6, 0.05};
    bar.boards = {{Vec3::Zero(), bar.size}};
    bar.pose = {{2.7, 2, profile.camera_height_m},
                Eigen::Quaterniond(Eigen::AngleAxisd(turn * std::numbers::pi / 4, Vec3::UnitX()))};
    scene.nodes.push_back(std::move(bar));
  }
  Viewer viewer(scene);
  const ViewedScene all = viewed(scene);
  const auto b = viewer.box_of(all, 0, scene.agent, profile), a = viewer.box_of(all, 1, scene.agent, profile);
  ASSERT_TRUE(a);
  ASSERT_EQ(a, b);
  EXPECT_EQ(viewer.first_with_box(all, 0, scene.agent, profile), std::nullopt);
  EXPECT_EQ(viewer.first_with_box(all, 1, scene.agent, profile), a);
  EXPECT_EQ(viewer.first_with_box(all, 2, scene.agent, profile), viewer.box_of(all, 2, scene.agent, profile));
}

/// A signal whose arm reaches through the wall: however far the eye looks, now and before, the wall hides the arm.
TEST(Viewer, DrawsTheWallsBeforeBoardsThatStandOutOfTheirObject) {
  const Profile profile = *load_profile(UNIETP_SOURCE_DIR "/data/simulators", Simulator::Ai2thor);
  Scene scene = testing::wide_kitchen(Simulator::Ai2thor);
  scene.nodes = {};
  scene.agent.position = {1.5, 2};
  scene.agent.yaw = scene.agent.pitch = 0;
  const auto add_box = [&](const char* id, double ahead, double aside, double side, bool arm) {
    Node box;
    box.id = id;
    box.category = "Signal";
    box.archetype = Archetype::Box;
    box.size = Vec3::Constant(side);
    box.boards = {{Vec3::Zero(), box.size}};
    if (arm) box.boards.push_back({{7, 0, 0}, {0.1, 4, 4}});
    box.pose.position = {1.5 + ahead, 2 + aside, profile.camera_height_m};
    scene.nodes.push_back(std::move(box));
  };
  add_box("signal", 0.4, 0, 0.05, true);
  add_box("shelf", 3, 1.5, 0.2, false);
  Rays rays;
  const auto by_rays = testing::pixels_by_rays(segmentation_of(scene, profile, rays), scene.nodes.size());
  Viewer viewer(scene);
  const ViewedScene all = viewed(scene);
  const std::vector<VisibleObject> near = viewer.view(all, scene.agent, profile, 0.5);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].box, by_rays[0].box);
  const std::vector<VisibleObject> both = viewer.view(all, scene.agent, profile, 20);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].box, by_rays[1].box);
  EXPECT_EQ(both[1].box, by_rays[0].box);
  EXPECT_EQ(viewer.box_of(all, 0, scene.agent, profile), by_rays[0].box);
}

}  // namespace
}  // namespace unietp
