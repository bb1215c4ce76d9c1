#include "interchange/unity.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "interchange/boxes.h"

namespace unietp {
namespace {

double turn_between(const Quat& a, const Quat& b) { return a.angularDistance(b); }

TEST(Unity, AModelThatIsNotTurnedFacesZWhichIsYOfW) {
  const Quat rotation = rotation_from_unity(Vec3::Zero());
  EXPECT_LT((rotation * -Vec3::UnitY() - Vec3::UnitY()).norm(), 1e-12) << "its front looks along Unity's z, our y";
  EXPECT_LT((rotation * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-12);
  const Quat quarter = rotation_from_unity({0, 90, 0});
  EXPECT_LT((quarter * -Vec3::UnitY() - Vec3::UnitX()).norm(), 1e-12) << "clockwise from above: now along x";
}

TEST(Unity, AnglesComeBackForAnyRotation) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Vec3 degrees(rng.uniform(0, 360), rng.uniform(0, 360), rng.uniform(0, 360));
    const Quat rotation = rotation_from_unity(seed % 4 == 0 ? Vec3(90, degrees.y(), degrees.z()) : degrees);
    EXPECT_LT(turn_between(rotation_from_unity(rotation_to_unity(rotation)), rotation), 1e-6);
  }
}

TEST(Unity, TheBoxOfEightCornersIsFoundInAnyOrder) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Vec3 size(rng.uniform(0.05, 2), rng.uniform(0.05, 2), rng.uniform(0.05, 2));
    const Quat facing = rotation_from_unity({rng.uniform(0, 360), rng.uniform(0, 360), rng.uniform(0, 360)});
    const Pose pose{{rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(0, 2)}, facing};
    std::vector<std::size_t> order{0, 1, 2, 3, 4, 5, 6, 7};
    rng.shuffle(order);
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3 sign((i & 1) ? 0.5 : -0.5, (i & 2) ? 0.5 : -0.5, (i & 4) ? 0.5 : -0.5);
      corners[order[i]] = pose * Vec3(sign.cwiseProduct(size));
    }
    const auto box = box_of_corners(corners, facing);
    ASSERT_TRUE(box);
    EXPECT_LT((box->pose.position - pose.position).norm(), 1e-9);
    EXPECT_LT((box->size - size).norm(), 1e-9);
    EXPECT_LT(turn_between(box->pose.rotation, facing), 1e-6);
  }
}

TEST(Unity, CornersOfNoBoxAreRefused) {
  std::array<Vec3, 8> corners;
  corners.fill(Vec3(1, 2, 3));
  EXPECT_FALSE(box_of_corners(corners, Quat::Identity()));
  for (std::size_t i = 0; i < 8; ++i) corners[i] = Vec3(static_cast<double>(i * i), static_cast<double>(i), 0);
  EXPECT_FALSE(box_of_corners(corners, Quat::Identity()));
}

TEST(Unity, AnAxisAlignedBoxGivesBackTheTurnedOneInIt) {
  for (const double degrees : {0.0, 90.0, 180.0, 2.0, 20.0, 110.0, 250.0}) {
    SCOPED_TRACE(degrees);
    const Quat facing = rotation_from_unity({0, degrees, 0});
    const Vec3 size(1.2, 0.5, 0.8);
    const Bounds around = bounds_of(Pose{Vec3::Zero(), facing}, size);
    const PosedBox box = box_within(Vec3::Zero(), around.high - around.low, facing);
    const Bounds again = bounds_of(box.pose, box.size);
    EXPECT_LT((again.high - around.high).norm(), degrees == 2.0 ? 0.05 : 1e-9);
    if (degrees == 2.0) continue;  // taken as straight
    EXPECT_LT((box.size - size).norm(), 1e-9);
  }
}

TEST(Boxes, WhatIsCutAndWhatIsLeftMakeTheWhole) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const auto corner = [&] { return Vec3(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)); };
    const Vec3 a = corner(), b = corner();
    const Bounds hole{a.cwiseMin(b), a.cwiseMax(b)};
    std::vector<Board> boards{board_between(Vec3::Constant(-0.7), Vec3::Constant(0.7), 1)};
    const bool any = cut(boards, hole);
    EXPECT_EQ(any, overlap(Bounds{Vec3::Constant(-0.7), Vec3::Constant(0.7)}, hole));
    double left = 0;
    for (const Board& board : boards) {
      EXPECT_EQ(board.joint, 1);
      EXPECT_FALSE(overlap(bounds_of(board), hole, -1e-9));
      left += board.size.prod();
    }
    const Vec3 shared = (hole.high.cwiseMin(0.7) - hole.low.cwiseMax(-0.7)).cwiseMax(0.0);
    EXPECT_NEAR(left + shared.prod(), 1.4 * 1.4 * 1.4, 0.03) << "slivers are dropped";
  }
}

}  // namespace
}  // namespace unietp
