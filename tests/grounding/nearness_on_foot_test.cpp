// Whether the nearest as the crow flies is the nearest for who walks.
#include "grounding/nearness_on_foot.h"

#include <gtest/gtest.h>

#include "grounding/reachability.h"
#include "homes.h"
#include "scene/trace.h"
#include "simulation/portrait.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

/// A room of 8 by 6 m with a desk, two mugs, and a long thing of 5 m that divides it.
struct DividedRoom {
  const Profile profile = style_of(Simulator::Ai2thor)->profile;
  Scene scene;

  DividedRoom(const Vec2& mug, const Vec2& other_mug) {
    scene.simulator = Simulator::Ai2thor;
    scene.rooms = {{"office_1", "office", {{0, 0}, {8, 0}, {8, 6}, {0, 6}}}};
    scene.agent.position = {7, 3};
    put("Desk", "desk_1", {1, 2.2}, {0.8, 0.5, 0.7});
    put("Sofa", "sofa_1", {2.5, 3}, {5, 0.4, 1.5});
    put("Mug", "mug_1", mug, {0.1, 0.1, 0.1});
    put("Mug", "mug_2", other_mug, {0.1, 0.1, 0.1});
  }

  void put(const char* category, const char* id, const Vec2& at, const Vec3& size) {
    const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
    Node node = object_of(knowledge, *knowledge.find(category), static_cast<std::uint32_t>(scene.nodes.size()));
    node.id = id;
    node.archetype = Archetype::Box;
    node.size = size;
    node.pose.position = {at.x(), at.y(), size.z() / 2};
    scene.nodes.push_back(node);
    scene.edges.insert({Predicate::InRoom, id, "office_1"});
  }

  std::optional<GroundingFailure> problem() const {
    const Formula goal = parsed("(exists (?a - (Mug :where (exists (?d - Desk) (nearest ?a ?d)))) (at-end (held ?a)))",
                                FormulaUse::Goal);
    return check_nearness_on_foot(goal, scene, NodeIndex(scene.nodes), to_logic(scene, {}, true),
                                  walk_in(scene, profile));
  }
};

TEST(NearnessOnFoot, IsMeasuredAroundWhatStandsInTheWay) {
  const DividedRoom room({1, 3.6}, {4.0, 2.2});
  const Walk walk = walk_in(room.scene, room.profile);
  const RoomWalk ways(walk, room.scene.rooms.front(), {1, 2.2});
  const auto around = ways.meters_to({1, 3.6}), straight = ways.meters_to({4.0, 2.2});
  ASSERT_TRUE(around);
  ASSERT_TRUE(straight);
  EXPECT_GT(*around, 7);
  EXPECT_LT(*straight, 4);
}

TEST(NearnessOnFoot, HasNoWayOutsideOfTheRoom) {
  const DividedRoom room({1, 3.6}, {4.0, 2.2});
  const Walk walk = walk_in(room.scene, room.profile);
  const Room half{"half_1", "office", {{0, 0}, {5, 0}, {5, 6}, {0, 6}}};
  const RoomWalk ways(walk, half, {1, 2.2});
  EXPECT_FALSE(ways.meters_to({1, 3.6}));
  EXPECT_TRUE(ways.meters_to({4.0, 2.2}));
}

/// What stands at a wall is walked to from its own room, however near the floor behind the wall is.
TEST(NearnessOnFoot, BeginsAndEndsOnTheFloorOfTheRoom) {
  DividedRoom room({6.5, 1.0}, {6.5, 5.0});
  room.scene.rooms.push_back({"hall_1", "hall", {{0, -3}, {8, -3}, {8, 0}, {0, 0}}});
  room.put("Cabinet", "cabinet_1", {4, 0.9}, {3, 1.7, 0.5});
  const Walk walk = walk_in(room.scene, room.profile);
  const Vec2 in_the_corner(4, 0.1);
  const auto over_there = walk.grid.nearest_free(in_the_corner);
  ASSERT_TRUE(over_there);
  ASSERT_LT(walk.grid.center(*over_there).y(), 0) << "the nearest free floor is in the hall";
  EXPECT_TRUE(RoomWalk(walk, room.scene.rooms.front(), {1, 2.2}).meters_to(in_the_corner));
}

TEST(NearnessOnFoot, RefusesTheNearestThatIsFarToWalkTo) {
  const auto problem = DividedRoom({1, 3.6}, {4.0, 2.2}).problem();
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->reason, RejectionReason::OddReference);
  EXPECT_NE(problem->detail.find("on foot"), std::string::npos);
}

TEST(NearnessOnFoot, AcceptsTheNearestOfBothSorts) { EXPECT_FALSE(DividedRoom({1.9, 1.2}, {6.5, 1.0}).problem()); }

/// Of two desks the mug has to be the nearest to one only.
TEST(NearnessOnFoot, IsAskedOfOneOfSeveralLandmarks) {
  DividedRoom room({1.9, 1.2}, {7.5, 0.6});
  room.put("Desk", "desk_2", {4.9, 1.2}, {0.8, 0.5, 0.7});
  EXPECT_FALSE(room.problem());
}

/// Another mug is the nearest to the desk on foot, and the one that is meant only as the crow flies.
TEST(NearnessOnFoot, RefusesWhatMeansAnotherThingOnFoot) {
  const DividedRoom room({1, 3.6}, {2.6, 1.0});
  EXPECT_TRUE(room.problem());
}

}  // namespace
}  // namespace unietp
