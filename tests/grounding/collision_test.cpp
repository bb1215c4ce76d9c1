#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "grounding/collision.h"

namespace unietp {
namespace {

struct OrientedBox {
  Pose pose;
  Vec3 size;
};

Pose random_pose(Rng& rng, double reach) {
  Eigen::Vector4d q(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1));
  if (q.norm() < 0.1) q = {1, 0, 0, 0};
  q.normalize();
  return {Vec3(rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)),
          Quat(q[0], q[1], q[2], q[3])};
}

OrientedBox random_box(Rng& rng, double reach) {
  return {random_pose(rng, reach), {rng.uniform(0.05, 0.6), rng.uniform(0.05, 0.6), rng.uniform(0.05, 0.6)}};
}

/// The oracle: the largest gap along the 15 separating axes of two boxes (positive: apart). Gottschalk et al. 1996.
double separation(const OrientedBox& a, const OrientedBox& b) {
  const Eigen::Matrix3d ra = a.pose.rotation.toRotationMatrix(), rb = b.pose.rotation.toRotationMatrix();
  std::vector<Vec3> axes;
  for (int i = 0; i < 3; ++i) {
    axes.push_back(ra.col(i));
    axes.push_back(rb.col(i));
    for (int j = 0; j < 3; ++j) {
      const Vec3 cross = ra.col(i).cross(rb.col(j));
      if (cross.norm() > 1e-6) axes.push_back(cross.normalized());
    }
  }
  double largest = -1e9;
  for (const Vec3& axis : axes) {
    double reach = 0;
    for (int i = 0; i < 3; ++i) {
      reach += std::abs(ra.col(i).dot(axis)) * a.size[i] / 2 + std::abs(rb.col(i).dot(axis)) * b.size[i] / 2;
    }
    largest = std::max(largest, std::abs((b.pose.position - a.pose.position).dot(axis)) - reach);
  }
  return largest;
}

Shape shape_of_box(const Vec3& size) {
  Shape shape;
  shape.parts.push_back({Part::Kind::Box, {}, size, -1});
  return shape;
}

TEST(PlacementChecker, AgreesWithSeparatingAxesOnRandomBoxes) {
  int hits = 0, misses = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Rng rng(seed);
    PlacementChecker checker;
    std::vector<OrientedBox> boxes;
    for (std::size_t i = 0; i < 12; ++i) {
      const auto id = BodyId::node(i);
      boxes.push_back(random_box(rng, 0.8));
      checker.set(id, shape_of_box(boxes.back().size), boxes.back().pose, 0);
    }
    for (int probe = 0; probe < 25; ++probe) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " probe " << probe);
      const OrientedBox box = random_box(rng, 0.8);
      OrientedBox grown = box;
      grown.size += Vec3::Constant(2 * PlacementChecker::kGap_m);
      std::optional<BodyId> expected;
      bool too_close_to_call = false;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double apart = separation(boxes[i], grown);
        too_close_to_call = too_close_to_call || std::abs(apart) < 1e-6;
        if (apart < 0 && !expected) expected = BodyId::node(i);
      }
      if (too_close_to_call) continue;
      EXPECT_EQ(checker.hit(shape_of_box(box.size), box.pose, 0), expected);
      ++(expected ? hits : misses);
    }
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(misses, 100);
}

TEST(PlacementChecker, KeepsAGapToWhatItAlmostTouches) {
  PlacementChecker checker;
  checker.set(BodyId::node(7), shape_of_box(Vec3::Constant(1)), Pose{}, 0);
  const auto probe_at = [&](double x) {
    return checker.hit(shape_of_box(Vec3::Constant(1)), upright({x, 0, 0}, 0), 0);
  };
  EXPECT_EQ(probe_at(1.0), BodyId::node(7)) << "exactly touching";
  EXPECT_EQ(probe_at(1.0009), BodyId::node(7)) << "less than a millimetre apart";
  EXPECT_EQ(probe_at(1.002), std::nullopt);
}

TEST(PlacementChecker, ForgetsWhatIsTakenOutAndLeavesOutWhatIsIgnored) {
  PlacementChecker checker;
  const Shape cube = shape_of_box(Vec3::Constant(0.2));
  checker.set(BodyId::node(1), cube, Pose{}, 0);
  checker.set(BodyId::node(2), cube, upright({0.05, 0, 0}, 0), 0);
  EXPECT_EQ(checker.hit(cube, Pose{}, 0), BodyId::node(1));
  const std::array<BodyId, 1> ignored{BodyId::node(1)};
  EXPECT_EQ(checker.hit(cube, Pose{}, 0, PlacementChecker::kGap_m, ignored), BodyId::node(2));
  checker.remove(BodyId::node(1));
  EXPECT_EQ(checker.hit(cube, Pose{}, 0), BodyId::node(2));
  checker.set(BodyId::node(2), cube, upright({5, 0, 0}, 0), 0);
  EXPECT_EQ(checker.hit(cube, Pose{}, 0), std::nullopt) << "a body that is set again has left its old place";
}

TEST(PlacementChecker, LaidOverAnotherAnswersAsOneThatWasBuiltSo) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    PlacementChecker base, built;
    for (std::size_t i = 0; i < 12; ++i) {
      const auto id = BodyId::node(i);
      const OrientedBox box = random_box(rng, 0.8);
      base.set(id, shape_of_box(box.size), box.pose, 0);
      built.set(id, shape_of_box(box.size), box.pose, 0);
    }
    const auto below = PlacementChecker::shared(std::move(base));
    PlacementChecker over(below), untouched(below);
    for (int change = 0; change < 6; ++change) {
      const auto id = BodyId::node(rng.below(14));
      const OrientedBox box = random_box(rng, 0.8);
      const bool gone = rng.chance(0.3);
      for (PlacementChecker* checker : {&over, &built}) {
        gone ? checker->remove(id) : checker->set(id, shape_of_box(box.size), box.pose, 0);
      }
    }
    int others = 0;
    for (int probe = 0; probe < 25; ++probe) {
      const OrientedBox box = random_box(rng, 0.8);
      const auto expected = built.hit(shape_of_box(box.size), box.pose, 0);
      EXPECT_EQ(over.hit(shape_of_box(box.size), box.pose, 0), expected);
      others += untouched.hit(shape_of_box(box.size), box.pose, 0) != expected ? 1 : 0;
    }
    EXPECT_GT(others, 0) << "the shared one has changed with it";
  }
}

TEST(PlacementChecker, SeesADoorWhereItStandsOpen) {
  const Shape cabinet = make_shape(Archetype::Cabinet, {0.6, 0.5, 0.8}, true);
  PlacementChecker checker;
  checker.set(BodyId::node(0), shape_of_box(Vec3::Constant(0.1)), upright({-0.3, -0.5, 0}, 0), 0);
  EXPECT_EQ(checker.hit_by_joints(cabinet, Pose{}, 0.0, 0.001), std::nullopt);
  EXPECT_EQ(checker.hit_by_joints(cabinet, Pose{}, 1.0, 0.001), BodyId::node(0));
  EXPECT_EQ(checker.hit(cabinet, Pose{}, 1.0), BodyId::node(0));
  EXPECT_EQ(checker.hit(cabinet, Pose{}, 0.0), std::nullopt);
}

TEST(PlacementChecker, ChecksRoundThingsAsRound) {
  PlacementChecker checker;
  Shape ball;
  ball.parts.push_back({Part::Kind::Sphere, {}, Vec3::Constant(1), -1});
  checker.set(BodyId::node(0), ball, Pose{}, 0);
  const Shape crumb = shape_of_box(Vec3::Constant(0.02));
  EXPECT_EQ(checker.hit(crumb, upright({0.4, 0.4, 0.4}, 0), 0), std::nullopt) << "in the corner of the ball's box";
  EXPECT_EQ(checker.hit(crumb, upright({0, 0, 0.49}, 0), 0), BodyId::node(0));
}

}  // namespace
}  // namespace unietp
