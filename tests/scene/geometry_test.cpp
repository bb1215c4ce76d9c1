#include "scene/geometry.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <gtest/gtest.h>

#include "core/rng.h"

namespace unietp {
namespace {

Pose random_pose(Rng& rng) {
  const Quat rotation(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1), rng.uniform(-1, 1));
  return {{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(-5, 5)}, rotation.normalized()};
}

TEST(Geometry, ComposedPosesMovePointsOneAfterTheOtherAndInversesUndoThem) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    const Pose a = random_pose(rng), b = random_pose(rng);
    const Vec3 point(rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3));
    EXPECT_TRUE(((a * b) * point).isApprox(a * (b * point), 1e-9)) << seed;
    EXPECT_TRUE((inverse(a) * (a * point)).isApprox(point, 1e-9)) << seed;
  }
}

TEST(Geometry, AnUprightPoseTurnsXTowardYAndTellsItsYaw) {
  const Pose quarter = upright({1, 2, 3}, std::numbers::pi / 2);
  EXPECT_TRUE((quarter * Vec3(1, 0, 0)).isApprox(Vec3(1, 3, 3), 1e-12));
  for (double yaw = -3.1; yaw < 3.1; yaw += 0.1) EXPECT_NEAR(yaw_of(upright(Vec3::Zero(), yaw)), yaw, 1e-12);
}

TEST(Geometry, BoundsAreThoseOfTheEightCornersForAnySeed) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    const Pose pose = random_pose(rng);
    const Vec3 size(rng.uniform(0.1, 2), rng.uniform(0.1, 2), rng.uniform(0.1, 2));
    Vec3 low = Vec3::Constant(1e9), high = Vec3::Constant(-1e9);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
      const Vec3 point = pose * Vec3(sign.cwiseProduct(size));
      low = low.cwiseMin(point), high = high.cwiseMax(point);
    }
    const Bounds bounds = bounds_of(pose, size);
    EXPECT_TRUE(bounds.low.isApprox(low, 1e-9) && bounds.high.isApprox(high, 1e-9)) << seed;
  }
}

TEST(Geometry, BoxesOverlapWhenTheyShareSpaceAndNotWhenTheyTouch) {
  const Bounds box{{0, 0, 0}, {1, 1, 1}}, beside{{1, 0, 0}, {2, 1, 1}}, above{{0, 0, 1.05}, {1, 1, 2}};
  EXPECT_TRUE(overlap(box, box));
  EXPECT_FALSE(overlap(box, beside));
  EXPECT_TRUE(overlap(box, beside, 0.01));
  EXPECT_FALSE(overlap(box, above, 0.04));
  EXPECT_TRUE(overlap(above, box, 0.06));
}

TEST(Geometry, APointOnASharedWallLiesInExactlyOneRoom) {
  const std::vector<Vec2> west{{0, 0}, {0.7, 0}, {1.1, 3}, {0, 3}}, east{{0.7, 0}, {4, 0}, {4, 3}, {1.1, 3}};
  for (int i = 1; i < 300; ++i) {
    const double t = i / 300.0;
    const Vec2 point(0.7 + 0.4 * t, 3 * t);
    EXPECT_NE(contains(west, point), contains(east, point)) << t;
  }
}

TEST(Geometry, TilesOfAFloorShareNoPointAndLeaveNoneOut) {
  const std::vector<Vec2> tiles[] = {
      {{0, 0}, {4, 0}, {2, 2}}, {{4, 0}, {4, 4}, {2, 2}}, {{4, 4}, {0, 4}, {2, 2}}, {{0, 4}, {0, 0}, {2, 2}}};
  for (double x = 0; x < 4; x += 0.25) {
    for (double y = 0; y < 4; y += 0.25) {  // many rays run through corners and along edges
      EXPECT_EQ(std::count_if(std::begin(tiles), std::end(tiles),
                              [&](const std::vector<Vec2>& tile) {
                                return contains(tile, {x, y});
                              }),
                1)
          << x << " " << y;
    }
  }
}

TEST(Geometry, AnLShapedRoomDoesNotHoldItsMissingCornerWhicheverWayItIsWound) {
  std::vector<Vec2> room{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  for (int winding = 0; winding < 2; ++winding) {
    EXPECT_TRUE(contains(room, {1, 1}));
    EXPECT_TRUE(contains(room, {3, 1}));
    EXPECT_TRUE(contains(room, {1, 3}));
    EXPECT_FALSE(contains(room, {3, 3}));
    EXPECT_FALSE(contains(room, {-1, 1}));
    std::reverse(room.begin(), room.end());
  }
  EXPECT_FALSE(contains({}, {0, 0}));
}

}  // namespace
}  // namespace unietp
