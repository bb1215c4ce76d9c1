#include "simulation/shape.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/rng.h"

namespace unietp {
namespace {

/// Do two parts of a shape overlap by more than a hair? For axis-aligned boxes at closed joints.
bool overlap_by(const Part& a, const Part& b, double depth) {
  const Bounds x = bounds_of(a.pose, a.size), y = bounds_of(b.pose, b.size);
  return (x.high.cwiseMin(y.high) - x.low.cwiseMax(y.low)).minCoeff() > depth;
}

TEST(ShapeOfANode, ItsOwnBoardsReplaceTheArchetypesSolidsAndKeepItsHollow) {
  Node fridge;
  fridge.archetype = Archetype::Cabinet;
  fridge.openable = true;
  fridge.size = {0.7, 0.65, 1.7};
  const Shape plain = shape_of(fridge);
  fridge.boards = {{{0, 0, 0.2}, {0.6, 0.5, 0.02}, -1},
                   {{0, 0, 0.84}, {0.7, 0.65, 0.02}, -1},
                   {{0, -0.32, 0}, {0.7, 0.01, 1.7}, 0},
                   {{0, 0, -0.5}, {0.6, 0.5, 0.02}, 7}};
  const Shape own = shape_of(fridge);
  EXPECT_EQ(own.joints.size(), plain.joints.size());
  EXPECT_EQ(own.cavities.size(), plain.cavities.size());
  ASSERT_EQ(own.parts.size(), 4u);
  EXPECT_EQ(own.parts[2].joint, 0);
  EXPECT_EQ(own.parts[3].joint, -1) << "no such joint";
  ASSERT_EQ(own.surfaces.size(), 3u) << "a door's edge is no place to put things";
  EXPECT_NEAR(own.surfaces[0].center.z(), 0.21, 1e-12);
  EXPECT_NEAR(own.surfaces[0].clearance, 0.62, 1e-12);
  EXPECT_EQ(own.surfaces[0].cavity, 0);
  EXPECT_EQ(own.surfaces[1].cavity, -1) << "on top of it";
  EXPECT_NEAR(own.surfaces[2].clearance, 0.68, 1e-12);
}

/// A counter of 2 x 0.6 m, 0.9 m high, of these boards.
Shape counter_of(std::vector<Board> boards) {
  Node counter;
  counter.archetype = Archetype::Block;
  counter.size = {2, 0.6, 0.9};
  counter.boards = std::move(boards);
  return shape_of(counter);
}

TEST(ShapeOfANode, ABoardThinnerThanAGapIsASurface) {
  const Shape shape = counter_of({{{0, 0, 0}, {2, 0.6, 0.9}, -1}, {{0, 0, 0.4505}, {2, 0.6, 0.001}, -1}});
  ASSERT_EQ(shape.surfaces.size(), 1u) << "the face below is covered";
  EXPECT_NEAR(shape.surfaces[0].center.z(), 0.451, 1e-12);
  EXPECT_NEAR(shape.surfaces[0].half.x(), 0.99, 1e-12);
  EXPECT_NEAR(shape.surfaces[0].clearance, 2, 1e-12);
}

TEST(ShapeOfANode, PiecesOfOneHeightAreOneSurfaceAroundAHole) {
  // What is left of the top around something of 10 cm that stands 10 cm from the middle.
  const Shape shape = counter_of({{{-0.475, 0, 0.44}, {1.05, 0.6, 0.02}, -1},
                                  {{0.575, 0, 0.44}, {0.85, 0.6, 0.02}, -1},
                                  {{0.1, -0.175, 0.44}, {0.1, 0.25, 0.02}, -1},
                                  {{0.1, 0.175, 0.44}, {0.1, 0.25, 0.02}, -1}});
  double longest = 0;
  for (const Surface& surface : shape.surfaces) longest = std::max(longest, surface.half.x());
  EXPECT_NEAR(longest, 0.99, 1e-9) << "before and behind the hole it goes all along";
}

TEST(ShapeOfANode, WhatHangsLowOverATopTakesOnlyItsOwnPartOfIt) {
  const Shape shape = counter_of({{{0, 0, 0}, {2, 0.6, 0.9}, -1}, {{-0.8, 0.1, 0.47}, {0.1, 0.1, 0.01}, -1}});
  double widest = 0;
  for (const Surface& surface : shape.surfaces) {
    if (surface.clearance > 1.9 && std::abs(surface.center.z() - 0.45) < 1e-9)
      widest = std::max(widest, surface.half.x() * surface.half.y());
    const Vec2 apart = (surface.center.head<2>() - Vec2(-0.8, 0.1)).cwiseAbs() - surface.half;
    const bool is_top = std::abs(surface.center.z() - 0.45) < 1e-9;
    EXPECT_FALSE(is_top && apart.maxCoeff() < 0) << "there are 1.5 cm below it";
  }
  EXPECT_GT(4 * widest, 1) << "of 1.2 square meters all but a strip";
}

TEST(MakeShape, KeepsEveryPartInsideTheBoxForAnySizeWhenClosed) {
  Rng rng(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3 size(rng.uniform(0.05, 2), rng.uniform(0.05, 1), rng.uniform(0.03, 2));
    for (const Archetype archetype : all_archetypes()) {
      if (archetype == Archetype::Sphere || archetype == Archetype::Cylinder) continue;  // round: width and depth agree
      SCOPED_TRACE(std::string(name_of(archetype)));
      for (const bool openable : {false, true}) {
        const Shape shape = make_shape(archetype, size, openable);
        ASSERT_FALSE(shape.parts.empty());
        const Bounds bounds = bounds_of(shape, {}, 0);
        EXPECT_LE((bounds.high - size / 2).maxCoeff(), 1e-9);
        EXPECT_GE((bounds.low + size / 2).minCoeff(), -1e-9);
        for (const Part& part : shape.parts) EXPECT_GT(part.size.minCoeff(), 0);
      }
    }
  }
}

TEST(MakeShape, LeavesCavitiesFreeOfSolidsExceptShelves) {
  const Shape fridge = make_shape(Archetype::Cabinet, {0.7, 0.65, 0.4}, true);  // low: one bay, no shelf
  ASSERT_EQ(fridge.cavities.size(), 1u);
  const Cavity& cavity = fridge.cavities.front();
  const Part hollow{Part::Kind::Box, {cavity.center, Quat::Identity()}, 2 * cavity.half, -1};
  for (const Part& part : fridge.parts) EXPECT_FALSE(overlap_by(part, hollow, 1e-9));
  EXPECT_GT(8 * cavity.half.prod(), 0.7 * 0.7 * 0.65 * 0.4);
}

/// What has a hollow is closed on all four sides, and its hollow and floor lie between the walls.
TEST(MakeShape, AHollowHasAWallOnEachSide) {
  const Vec3 size(0.4, 0.3, 0.2);
  for (const Archetype archetype : {Archetype::Basin, Archetype::Vessel, Archetype::Lidded}) {
    SCOPED_TRACE(std::string(name_of(archetype)));
    const Shape shape = make_shape(archetype, size, archetype == Archetype::Lidded);
    ASSERT_EQ(shape.cavities.size(), 1u);
    const Cavity& cavity = shape.cavities.front();
    const double height = cavity.center.z();
    for (const Vec3& side :
         {Vec3(0.199, 0, height), Vec3(-0.199, 0, height), Vec3(0, 0.149, height), Vec3(0, -0.149, height)}) {
      EXPECT_TRUE(std::any_of(shape.parts.begin(), shape.parts.end(), [&](const Part& part) {
        const Bounds bounds = bounds_of(part.pose, part.size);
        return (bounds.high - side).minCoeff() >= 0 && (side - bounds.low).minCoeff() >= 0;
      })) << side.transpose();
    }
    EXPECT_LT((cavity.center.cwiseAbs() + cavity.half - size / 2).head<2>().maxCoeff(), 0);
    const Part hollow{Part::Kind::Box, {cavity.center, Quat::Identity()}, 2 * cavity.half, -1};
    for (const Part& part : shape.parts) EXPECT_FALSE(overlap_by(part, hollow, 1e-9));
    const auto floor = std::find_if(shape.surfaces.begin(), shape.surfaces.end(),
                                    [](const Surface& surface) { return surface.cavity == 0; });
    ASSERT_NE(floor, shape.surfaces.end());
    EXPECT_LE((floor->half - cavity.half.head<2>()).maxCoeff(), 0);
  }
}

/// Every shelf that things fit on has a board at its bottom, one on top, and one between each two bays.
TEST(MakeShape, AShelfHasABoardBelowAndAboveEachBay) {
  for (const auto& [height, bays] : {std::pair(0.2, 1), {0.4, 1}, {0.84, 2}, {1.7, 4}}) {
    SCOPED_TRACE(height);
    const Shape shelf = make_shape(Archetype::Shelf, {0.8, 0.3, height}, false);
    ASSERT_EQ(shelf.surfaces.size(), bays + 1U);
    EXPECT_NEAR(shelf.surfaces.front().center.z(), -height / 2 + 0.02, 1e-9);
    EXPECT_NEAR(shelf.surfaces.back().center.z(), height / 2, 1e-9);
    for (std::size_t i = 1; i < shelf.surfaces.size(); ++i) {
      const double rise = shelf.surfaces[i].center.z() - shelf.surfaces[i - 1].center.z();
      EXPECT_NEAR(shelf.surfaces[i - 1].clearance, rise - 0.02, 1e-9) << "up to the board above";
    }
  }
}

TEST(MakeShape, ADoorSwingsOutInFrontAndAnOpenDrawerSlidesOut) {
  const Shape cabinet = make_shape(Archetype::Cabinet, {0.6, 0.5, 0.8}, true);
  EXPECT_NEAR(bounds_of(cabinet, {}, 1).low.y(), -0.25 - 0.6, 0.03);
  EXPECT_NEAR(bounds_of(cabinet, {}, 1).high.y(), 0.25, 1e-9);
  const Shape chest = make_shape(Archetype::Drawers, {0.6, 0.5, 0.8}, true);
  EXPECT_NEAR(bounds_of(chest, {}, 1).low.y(), -0.25 - 0.8 * 0.48, 0.03);
}

TEST(MakeShape, ALidOpensUpwardsAndPastUpright) {
  const Shape box = make_shape(Archetype::Lidded, {0.4, 0.3, 0.2}, true);
  EXPECT_GT(bounds_of(box, {}, 0.5).high.z(), 0.3);
  EXPECT_GT(bounds_of(box, {}, 1).high.y(), 0.15);
}

}  // namespace
}  // namespace unietp
