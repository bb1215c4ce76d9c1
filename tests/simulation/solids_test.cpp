// Where rays enter the solids of shapes: a march along each ray with a test of points is the oracle.
#include <cmath>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "simulation/outline.h"
#include "simulation/ray_entry.h"
#include "simulation/shape_coverage.h"
#include "simulation/solids.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

/// Whether a point of the solid's own frame is in its material.
bool inside(const RayTarget& solid, const Vec3& at) {
  const auto within = [&](const Vec2& low, const Vec2& high, double bottom, bool round) {
    if (at.z() < bottom || at.z() > 1) return false;
    const Vec2 wide = low + (high - low) * (at.z() - bottom) / (1 - bottom);
    if (round) return at.head<2>().norm() <= wide.x();
    return std::abs(at.x()) <= wide.x() && std::abs(at.y()) <= wide.y();
  };
  const bool round = solid.kind == SolidKind::Cone || solid.kind == SolidKind::Cup;
  if (!within(solid.low, solid.high, -1, round)) return false;
  if (!solid.hollow()) return true;
  const double bottom = -1 + solid.floor;
  const Vec2 wall = Vec2::Constant(solid.wall);
  return !within(solid.low + (solid.high - solid.low) * solid.floor / 2 - wall, solid.high - wall, bottom, round);
}

Vec3 drawn(Rng& rng, double reach) {
  return {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
}

Solid drawn_solid(SolidKind kind, Rng& rng) {
  Solid solid;
  solid.kind = kind;
  solid.sheared = true;
  solid.axes = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) solid.axes.col(i) += drawn(rng, 0.3);
  if (kind == SolidKind::Box || kind == SolidKind::Cylinder || kind == SolidKind::Sphere) return solid;
  solid.low = Vec2::Constant(rng.uniform(0.3, 1));
  solid.high = Vec2::Constant(rng.uniform(0.3, 1));
  if (kind == SolidKind::Wedge || kind == SolidKind::Crate) solid.low.y() = rng.uniform(0.3, 1);
  solid.wall = rng.uniform(0.02, 0.2);
  solid.floor = rng.uniform(0.05, 0.4);
  return solid;
}

class ShapeSolid : public ::testing::TestWithParam<SolidKind> {};

TEST_P(ShapeSolid, IsEnteredWhereAMarchAlongTheRayEntersIt) {
  Rng rng(11);
  int hits = 0, hollow_hits = 0;
  for (int i = 0; i < 1500; ++i) {
    const RayTarget target(drawn_solid(GetParam(), rng));
    const bool from_hollow = target.hollow() && rng.chance(0.3);
    const Vec3 from = from_hollow ? Vec3(0, 0, 0.5) : Vec3(drawn(rng, 3));
    const Vec3 way = from_hollow ? Vec3(drawn(rng, 1)) : Vec3(drawn(rng, 0.8) - from);
    if (inside(target, from)) continue;
    constexpr double kStep = 0.001;
    double found = kNever;
    for (double along = 0; along < 3 && found == kNever; along += kStep) {
      if (inside(target, from + along * way)) found = along;
    }
    const RayEntry entry = enter(target, from, way);
    if (found == kNever || entry.along == kNever) {
      // The march may step over an edge, by which a ray passes through less than a step of material.
      if (entry.along < 3) {
        EXPECT_FALSE(inside(target, from + (entry.along + 2 * kStep) * way)) << i;
      }
      EXPECT_EQ(found, kNever) << i;
      continue;
    }
    EXPECT_NEAR(entry.along, found, 2 * kStep) << i;
    EXPECT_LT(entry.normal.dot(way), 1e-9) << i << ": the normal must look against the ray";
    ++hits;
    hollow_hits += from_hollow ? 1 : 0;
  }
  EXPECT_GT(hits, 400);
  if (GetParam() == SolidKind::Cup || GetParam() == SolidKind::Crate) {
    EXPECT_GT(hollow_hits, 100);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShapeSolid,
                         ::testing::Values(SolidKind::Wedge, SolidKind::Cone, SolidKind::Cup, SolidKind::Crate));

TEST(ShapeSolids, OutlinesCoverEveryPixelThatARayFinds) {
  Rng rng(5);
  Camera camera;
  camera.width = camera.height = 120;
  camera.focal = 90;
  int pixels = 0;
  for (int i = 0; i < 200; ++i) {
    Solid solid = drawn_solid(static_cast<SolidKind>(static_cast<int>(rng.below(7))), rng);
    solid.axes *= rng.uniform(0.05, 0.6);
    solid.pose.position = {rng.uniform(1.5, 4), rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)};
    const auto outline = outline_of(solid, camera);
    const RayTarget target(solid);
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        const Vec3 from = target.to_own * (camera.at - target.center);
        const double along = enter(target, from, target.to_own * camera.ray(x + 0.5, y + 0.5)).along;
        if (along == kNever) continue;
        ++pixels;
        ASSERT_TRUE(outline.has_value());
        const PixelBox& cover = outline->cover;
        ASSERT_TRUE(x >= cover[0] && y >= cover[1] && x <= cover[2] && y <= cover[3]) << i;
        ASSERT_GE(along, outline->nearest - 1e-9);
        ASSERT_LE(along, outline->farthest + 1e-9);
      }
    }
  }
  EXPECT_GT(pixels, 20'000);
}

class ShapesOf : public ::testing::TestWithParam<Simulator> {};

TEST_P(ShapesOf, LeaveAtMostATenthOfTheMovableCategoriesPlainBoxes) {
  const ShapeCoverage coverage = shape_coverage(committed_knowledge(GetParam()));
  EXPECT_GT(coverage.movable, 60U);
  EXPECT_LE(10 * coverage.plain_boxes, coverage.movable);
  EXPECT_GE(10 * coverage.movable_shown, 9 * coverage.movable);
}

TEST_P(ShapesOf, FillTheBoxOfEveryCategoryAndKeepItsSizes) {
  const Knowledge& knowledge = committed_knowledge(GetParam());
  for (const Category& category : knowledge.categories()) {
    SCOPED_TRACE(category.name);
    Node node;
    node.id = category.name;
    node.category = category.name;
    node.archetype = category.archetype;
    node.size = category.size;
    const ShapeFamily* family = family_of(node, GetParam());
    if (family == nullptr || family->keeps_body) continue;
    for (const Error& fault : faults_of(*family, category.size, 0.004)) ADD_FAILURE() << format(fault);
    std::vector<Solid> solids;
    add_solids(node, 0, GetParam(), {}, solids);
    ASSERT_FALSE(solids.empty());
    for (const Solid& solid : solids) {
      EXPECT_TRUE(solid.sheared);
      EXPECT_LE((solid.pose.position.cwiseAbs() - node.size / 2).maxCoeff(), 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShapesOf, ::testing::ValuesIn(kSimulators.begin(), kSimulators.end()));

}  // namespace
}  // namespace unietp
