// What goals refer to, and how far that is on foot: measured apart from grounding, which makes the starts.
#include "validator/referents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/geometry.h"
#include "scene/trace.h"
#include "tests/expert/house.h"
#include "validator/room_ways.h"

namespace unietp::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The house with a potato at each of two places of the kitchen, and one in the living room.
struct Potatoes : ::testing::Test {
  const Profile profile = house_profile();
  Scene scene = house();

  void SetUp() override {
    erase_if(scene.nodes, [](const Node& node) { return node.category == "Potato"; });
  }
  void put(const char* id, double x, double y) { add(scene, house_knowledge(), id, "Potato", x, y, 0.01); }
  Referents of(const std::string& where) {
    scene = at_rest(scene);
    const Formula wanted = goal("(exists (?p - (Potato :where " + where + ")) (at-end (held ?p)))");
    const auto all = referents_of(wanted, scene, to_logic(scene, {}, true), profile);
    EXPECT_EQ(all.size(), 1U);
    return all.front();
  }
};
constexpr const char* kAtTheFridge = "(exists (?f - Fridge) (nearest ?p ?f))";

TEST_F(Potatoes, TheNearestIsSoOnFoot) {
  put("potato_1", 4.0, 2.8);
  put("potato_2", 1.2, 2.4);
  const Referents found = of(kAtTheFridge);
  EXPECT_THAT(found.means, ElementsAre("potato_1"));
  EXPECT_EQ(found.kind, "nearness");
  EXPECT_THAT(found.beyond_wall, IsEmpty());
  EXPECT_THAT(found.rivals, IsEmpty());
  EXPECT_THAT(found.idle, IsEmpty());
}

TEST_F(Potatoes, WhatIsNearestBehindAWallIsFound) {
  put("potato_1", 5.4, 3.55);  // in the living room, behind the wall that the fridge stands at
  put("potato_2", 3.0, 2.6);
  const Referents found = of(kAtTheFridge);
  EXPECT_THAT(found.means, ElementsAre("potato_1"));
  EXPECT_THAT(found.beyond_wall, ElementsAre("potato_1"));
  EXPECT_THAT(found.rivals, ElementsAre("potato_2"));
}

TEST_F(Potatoes, ATestThatTellsFromNothingIsIdle) {
  put("potato_1", 4.0, 2.8);
  put("potato_2", 8.0, 2.0);
  const Referents found = of("(and (exists (?r - kitchen) (in_room ?p ?r)) (exists (?r - kitchen) (on_floor ?p ?r)))");
  EXPECT_EQ(found.kind, "relation+room");
  EXPECT_EQ(found.idle.size(), 2U) << "either says it all";
  ReferentCounts counts;
  counts.add(found);
  EXPECT_EQ(counts.referents, 1);
  EXPECT_EQ(counts.without_alternative, 1);
  EXPECT_EQ(counts.beyond_wall, 0);
}

TEST_F(Potatoes, WhatIsToldByARelationHasOthersWithAnotherRelation) {
  const auto on_table = [this] { return of("(exists (?t - DiningTable) (on ?p ?t))"); };
  add(scene, house_knowledge(), "potato_1", "Potato", 2.75, 1.25, 0.751);
  put("potato_2", 1.2, 2.4);  // on the floor: on nothing
  const Referents alone = on_table();
  EXPECT_THAT(alone.means, ElementsAre("potato_1"));
  EXPECT_EQ(alone.unrelated.size(), 1U);
  ReferentCounts counts;
  counts.add(alone);
  EXPECT_EQ(counts.without_relation, 1);
  add(scene, house_knowledge(), "potato_3", "Potato", 2.3, 3.65, 0.902);  // on the counter
  EXPECT_THAT(on_table().unrelated, IsEmpty());
}

TEST(WaysInARoom, LeadAroundFurnitureAndEndAtWalls) {
  const Scene scene = at_rest(house());
  const NavigationGrid grid(scene, house_profile());
  const CellSet reached = grid.reached_from(grid.cell_at(scene.agent.position));
  const auto meters = [&](const Vec2& from, const Vec2& to) {
    return RoomWays(grid, reached, scene.rooms[0], from).meters(to);
  };
  const auto around = meters({2.5, 0.3}, {2.5, 1.9});  // on both sides of the table
  ASSERT_TRUE(around);
  EXPECT_GT(*around, 1.6);
  const auto back = meters({2.5, 1.9}, {2.5, 0.3});
  ASSERT_TRUE(back);
  EXPECT_NEAR(*back, *around, 1e-9);
  const auto straight = meters({0.9, 2.6}, {3.9, 2.6});
  ASSERT_TRUE(straight);
  EXPECT_NEAR(*straight, 3, 0.3);
}

}  // namespace
}  // namespace unietp::testing
