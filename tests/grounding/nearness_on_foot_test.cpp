// Whether the nearest as the crow flies is the nearest for who walks.
#include "grounding/nearness_on_foot.h"

#include <gtest/gtest.h>

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
                                  NavigationGrid(scene, profile));
  }
};

TEST(NearnessOnFoot, IsMeasuredAroundWhatStandsInTheWay) {
  const DividedRoom room({1, 3.6}, {4.0, 2.2});
  const NavigationGrid grid(room.scene, room.profile);
  const auto around = on_foot(grid, room.scene.rooms.front(), {1, 2.2}, {1, 3.6});
  const auto straight = on_foot(grid, room.scene.rooms.front(), {1, 2.2}, {4.0, 2.2});
  ASSERT_TRUE(around);
  ASSERT_TRUE(straight);
  EXPECT_GT(*around, 7);
  EXPECT_LT(*straight, 4);
}

TEST(NearnessOnFoot, HasNoWayOutsideOfTheRoom) {
  const DividedRoom room({1, 3.6}, {4.0, 2.2});
  const NavigationGrid grid(room.scene, room.profile);
  const Room half{"half_1", "office", {{0, 0}, {5, 0}, {5, 6}, {0, 6}}};
  EXPECT_FALSE(on_foot(grid, half, {1, 2.2}, {1, 3.6}));
  EXPECT_TRUE(on_foot(grid, half, {1, 2.2}, {4.0, 2.2}));
}

TEST(NearnessOnFoot, RefusesTheNearestThatIsFarToWalkTo) {
  const auto problem = DividedRoom({1, 3.6}, {4.0, 2.2}).problem();
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->reason, RejectionReason::OddReference);
  EXPECT_NE(problem->detail.find("on foot"), std::string::npos);
}

TEST(NearnessOnFoot, AcceptsTheNearestOfBothSorts) { EXPECT_FALSE(DividedRoom({1.9, 1.2}, {6.5, 1.0}).problem()); }

}  // namespace
}  // namespace unietp
