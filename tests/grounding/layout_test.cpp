#include "grounding/layout.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "grounding/floor_plan.h"
#include "homes.h"
#include "scene/scene_json.h"
#include "simulation/navigation.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

constexpr std::uint64_t kSeeds = 4;

struct Solid {
  Eigen::Matrix3d axes;
  Vec3 centre, half;
  std::size_t node;
};

/// Boxes of all parts where they stand; cylinders and balls by the box inside them, so that touching is not overlap.
std::vector<Solid> solids_of(const Scene& scene) {
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const Shape shape = shape_of(node);
    for (const Part& part : shape.parts) {
      const Pose pose = node.pose * joint_motion(shape, part.joint, node.opening) * part.pose;
      Vec3 half = part.size / 2;
      if (part.kind == Part::Kind::Cylinder) half.head<2>() *= std::sqrt(0.5);
      if (part.kind == Part::Kind::Sphere) half *= std::sqrt(1.0 / 3);
      solids.push_back({pose.rotation.toRotationMatrix(), pose.position, half, i});
    }
  }
  return solids;
}

/// How deep two oriented boxes overlap along the best of the 15 separating axes; negative when they are apart.
double depth_of(const Solid& a, const Solid& b) {
  std::vector<Vec3> axes;
  for (int i = 0; i < 3; ++i) {
    axes.push_back(a.axes.col(i));
    axes.push_back(b.axes.col(i));
    for (int j = 0; j < 3; ++j) {
      const Vec3 cross = a.axes.col(i).cross(b.axes.col(j));
      if (cross.norm() > 1e-6) axes.push_back(cross.normalized());
    }
  }
  double least = 1e9;
  for (const Vec3& axis : axes) {
    double reach = 0;
    for (int i = 0; i < 3; ++i) {
      reach += std::abs(a.axes.col(i).dot(axis)) * a.half[i] + std::abs(b.axes.col(i).dot(axis)) * b.half[i];
    }
    least = std::min(least, reach - std::abs((b.centre - a.centre).dot(axis)));
  }
  return least;
}

class EveryHome : public testing::TestWithParam<Simulator> {
 protected:
  void SetUp() override {
    style_ = style_of(GetParam());
    ASSERT_TRUE(style_);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      auto home = home_of(*style_, seed);
      ASSERT_TRUE(home) << "seed " << seed << ": " << format(home.error());
      homes_.push_back(std::move(*home));
    }
  }
  std::optional<Surroundings> style_;
  std::vector<Scene> homes_;
};

TEST_P(EveryHome, HasFiveRoomsOfUsualSizeAndEightyObjectsWithUniqueIds) {
  for (const Scene& home : homes_) {
    EXPECT_GE(home.rooms.size(), 5u);
    EXPECT_GE(home.nodes.size(), 80u);
    for (const Room& room : home.rooms) {
      const Bounds bounds = room_bounds(room, 1);
      const double area = (bounds.high - bounds.low).prod();
      EXPECT_GE(area, 9) << room.id;
      EXPECT_LE(area, 30) << room.id;
    }
    std::set<std::string> ids;
    for (const Node& node : home.nodes) EXPECT_TRUE(ids.insert(node.id).second) << node.id;
  }
}

TEST_P(EveryHome, LetsTheBodyWalkIntoEveryRoom) {
  for (const Scene& home : homes_) {
    const NavigationGrid grid(home, style_->profile);
    const auto start = grid.cell_at(home.agent.position);
    ASSERT_TRUE(grid.free(start));
    ASSERT_EQ(room_at(home, home.agent.position), &home.rooms.front());
    const auto walk = grid.distances(start);
    for (const Room& room : home.rooms) {
      bool reached = false;
      for (int y = 0; y < grid.height(); ++y) {
        for (int x = 0; x < grid.width(); ++x) {
          const bool walked = walk[static_cast<std::size_t>(y * grid.width() + x)] >= 0;
          reached = reached || (walked && contains(room.polygon, grid.centre({x, y})));
        }
      }
      EXPECT_TRUE(reached) << room.id;
    }
  }
}

TEST_P(EveryHome, HasNoTwoBodiesInOneAnother) {
  for (const Scene& home : homes_) {
    const auto solids = solids_of(home);
    for (std::size_t i = 0; i < solids.size(); ++i) {
      for (std::size_t j = i + 1; j < solids.size(); ++j) {
        if (solids[i].node == solids[j].node) continue;
        if ((solids[i].centre - solids[j].centre).norm() > solids[i].half.norm() + solids[j].half.norm()) continue;
        // Physics lets resting bodies sink into one another by a fraction of a millimetre.
        EXPECT_LT(depth_of(solids[i], solids[j]), 1.5e-3)
            << home.nodes[solids[i].node].id << " and " << home.nodes[solids[j].node].id;
      }
    }
  }
}

TEST_P(EveryHome, StaysAsItIsForTwoSecondsOfPhysics) {
  for (const Scene& home : homes_) {
    std::vector<BodyId> loose;
    for (std::size_t i = 0; i < home.nodes.size(); ++i) {
      if (home.nodes[i].movable) loose.push_back(static_cast<BodyId>(i));
    }
    SettleOptions two_seconds;
    two_seconds.max_steps = 480;
    two_seconds.calm_steps = 481;  // never stop early
    const Settled settled = physics_of(home).settle(loose, two_seconds);
    for (const SettledBody& body : settled.bodies) {
      const Node& node = home.nodes[body.body];
      EXPECT_LT((body.pose.position - node.pose.position).norm(), 0.005) << node.id;
      const double turned = node.pose.rotation.angularDistance(body.pose.rotation) * 180 / M_PI;
      EXPECT_LT(turned, 2.0) << node.id;
    }
  }
}

TEST_P(EveryHome, PutsThingsOnlyWhereTheKnowledgeAllows) {
  for (const Scene& home : homes_) {
    EXPECT_EQ(home.edges, read_relations(home)) << "edges are those that physics shows";
    int related = 0;
    for (const Edge& edge : home.edges) {
      if (edge.relation != Predicate::On && edge.relation != Predicate::Inside) continue;
      const Node* object = find_node(home, edge.from);
      if (!object->movable) continue;
      ++related;
      EXPECT_NE(
          style_->knowledge.placement(object->category, info(edge.relation).name, find_node(home, edge.to)->category),
          nullptr)
          << edge.from << " " << info(edge.relation).name << " " << edge.to;
    }
    EXPECT_GE(related, 40);
  }
}

TEST_P(EveryHome, HasStatesThatFitTheAffordancesAndDoorsThatAgreeWithThem) {
  for (const Scene& home : homes_) {
    for (const Node& node : home.nodes) {
      for (const StateGroup& group : state_groups()) {
        const auto held = std::count_if(group.predicates.begin(), group.predicates.end(),
                                        [&](Predicate p) { return node.states.has(p); });
        EXPECT_EQ(held, style_->knowledge.has(node.category, group.affordance) ? 1 : 0) << node.id << group.affordance;
      }
      EXPECT_EQ(node.states.has(Predicate::Open), node.opening > 0.5) << node.id;
    }
  }
}

TEST_P(EveryHome, KeepsFurnitureInItsRoomAndItsDoorsFree) {
  for (const Scene& home : homes_) {
    const PhysicsWorld world = physics_of(home);
    for (std::size_t i = 0; i < home.nodes.size(); ++i) {
      const Node& node = home.nodes[i];
      if (node.movable || !node.openable) continue;
      std::vector<BodyId> ignore{static_cast<BodyId>(i)};
      for (const std::string& id : carried_by(home, node.id)) {  // rides along in a drawer
        ignore.push_back(static_cast<BodyId>(find_node(home, id) - home.nodes.data()));
      }
      for (const Edge& edge : home.edges) {  // stands on it: a door ends a hair above
        if (edge.from == node.id && edge.relation == Predicate::On) {
          ignore.push_back(static_cast<BodyId>(find_node(home, edge.to) - home.nodes.data()));
        }
      }
      for (const double opening : {0.3, 0.6, 1.0}) {
        const auto hit = world.overlap(shape_of(node), node.pose, opening, ignore, 0.002);
        EXPECT_FALSE(hit) << node.id << " at " << opening << " hits "
                          << (*hit < home.nodes.size() ? home.nodes[*hit].id : "a wall");
      }
    }
  }
}

TEST_P(EveryHome, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const auto again = home_of(*style_, 1);
  ASSERT_TRUE(again);
  EXPECT_EQ(scene_to_json(*again), scene_to_json(homes_[1]));
  EXPECT_NE(scene_to_json(homes_[0]), scene_to_json(homes_[1]));
}

TEST_P(EveryHome, GrowsToSevenRoomsAndTwoHundredObjects) {
  const auto large = home_of(*style_, 5, 7, 140);
  ASSERT_TRUE(large) << format(large.error());
  EXPECT_EQ(large->rooms.size(), 7u);
  EXPECT_GE(large->nodes.size(), 190u);
}

INSTANTIATE_TEST_SUITE_P(Simulators, EveryHome, testing::ValuesIn(kSimulators),
                         [](const auto& one) { return std::string(name_of(one.param)); });

TEST(GenerateLayout, SaysWhichObligatoryPieceFindsNoPlace) {
  auto style = style_of(Simulator::Ai2thor);
  ASSERT_TRUE(style);
  style->recipe.furniture = {{"bathroom", "Bathtub", 20, 20, "wall"}};
  const auto home = home_of(*style, 0);
  ASSERT_FALSE(home);
  EXPECT_EQ(home.error().kind, Error::Kind::Unsatisfiable);
  EXPECT_NE(home.error().message.find("Bathtub"), std::string::npos) << home.error().message;
}

TEST(FloorPlan, JoinsAllRoomsByOpeningsInSharedWalls) {
  int drawn = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto plan = draw_floor_plan(
        {"kitchen", "living_room", "bedroom", "bathroom", "dining_room", "bedroom", "corridor"}, Rng(seed));
    if (!plan) continue;
    ++drawn;
    std::set<std::string> joined{plan->rooms.front().id};
    for (std::size_t pass = 0; pass < plan->rooms.size(); ++pass) {
      for (const Opening& opening : plan->openings) {
        if (joined.contains(opening.room_a) || joined.contains(opening.room_b)) {
          joined.insert(opening.room_a);
          joined.insert(opening.room_b);
        }
      }
    }
    EXPECT_EQ(joined.size(), plan->rooms.size()) << "seed " << seed;
    for (const Opening& opening : plan->openings) {
      EXPECT_NEAR((opening.to - opening.from).norm(), kOpeningWidth_m, 1e-9);
    }
  }
  EXPECT_GT(drawn, 10);
}

}  // namespace
}  // namespace unietp
