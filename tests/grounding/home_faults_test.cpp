#include "grounding/home_faults.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "homes.h"

namespace unietp {
namespace {

using ::testing::IsEmpty;

/// A sound home of AI2-THOR in which one thing is spoiled.
class HomeFaults : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    style_ = new Surroundings(*style_of(Simulator::Ai2thor));
    sound_ = new Scene(*home_of(*style_, 3));
  }
  static void TearDownTestSuite() {
    delete style_;
    delete sound_;
  }

  static std::vector<HomeFinding> faults(const Scene& scene) {
    return faults_of(scene, style_->knowledge, style_->profile);
  }
  /// The first fault of this kind.
  static HomeFinding found(const Scene& scene, HomeFault fault) {
    for (const HomeFinding& finding : faults(scene)) {
      if (finding.fault == fault) return finding;
    }
    return {fault, "none", "", "", 0};
  }
  static std::size_t first_movable(const Scene& scene) {
    std::size_t i = 0;
    while (!scene.nodes[i].movable) ++i;
    return i;
  }
  static std::size_t first_furniture(const Scene& scene, bool openable) {
    std::size_t i = 0;
    while (scene.nodes[i].movable || scene.nodes[i].openable != openable) ++i;
    return i;
  }
  static Surroundings* style_;
  static Scene* sound_;
};
Surroundings* HomeFaults::style_ = nullptr;
Scene* HomeFaults::sound_ = nullptr;

TEST_F(HomeFaults, AGeneratedHomeHasNoneInAnySimulator) {
  for (const Simulator simulator : kSimulators) {
    const auto style = style_of(simulator);
    ASSERT_TRUE(style);
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      const auto home = full_home_of(*style, seed);
      ASSERT_TRUE(home);
      for (const HomeFinding& finding : faults_of(*home, style->knowledge, style->profile))
        ADD_FAILURE() << name_of(simulator) << " " << seed << ": " << finding.object << " " << name_of(finding.fault)
                      << " " << finding.other << " " << finding.by_m;
    }
  }
}

TEST_F(HomeFaults, ThingsInOneAnotherAreAnOverlapWithItsDepth) {
  Scene home = *sound_;
  const std::size_t furniture = first_furniture(home, false);
  Node twin = home.nodes[furniture];
  twin.id = "twin_1";
  twin.pose.position.x() += 0.01;
  home.nodes.push_back(twin);
  const HomeFinding finding = found(home, HomeFault::Overlap);
  EXPECT_EQ(finding.object, home.nodes[furniture].id);
  EXPECT_EQ(finding.other, "twin_1");
  EXPECT_GT(finding.by_m, 0.002);
}

TEST_F(HomeFaults, AThingInTheAirIsRestlessWithItsFall) {
  Scene home = *sound_;
  const std::size_t thing = first_movable(home);
  home.nodes.edit(thing).pose.position.z() += 0.2;
  const HomeFinding finding = found(home, HomeFault::Restless);
  EXPECT_EQ(finding.object, home.nodes[thing].id);
  EXPECT_NEAR(finding.by_m, 0.2, 0.02);
}

TEST_F(HomeFaults, WhatIsBelowTheFloorIsSunkByItsDepth) {
  Scene home = *sound_;
  const std::size_t furniture = first_furniture(home, false);
  Node& node = home.nodes.edit(furniture);
  node.pose.position.z() = node.size.z() / 2 - 0.07;
  const HomeFinding finding = found(home, HomeFault::Sunk);
  EXPECT_EQ(finding.object, node.id);
  EXPECT_NEAR(finding.by_m, 0.07, 0.002);
}

TEST_F(HomeFaults, WhatAPersonCouldPickUpButIsFixedIsFrozen) {
  Scene home = *sound_;
  const std::size_t thing = first_movable(home);
  home.nodes.edit(thing).movable = false;
  EXPECT_EQ(found(home, HomeFault::Frozen).object, home.nodes[thing].id);
}

TEST_F(HomeFaults, WhatLiesInTheGardenIsOutsideRooms) {
  Scene home = *sound_;
  const std::size_t thing = first_furniture(home, false);
  Node& node = home.nodes.edit(thing);
  node.pose.position.head<2>() = Vec2(-30, -30);
  EXPECT_EQ(found(home, HomeFault::OutsideRooms).object, node.id);
  EXPECT_EQ(found(home, HomeFault::OutOfReach).object, node.id);
}

TEST_F(HomeFaults, FurnitureInTheMiddleOfTheAirFloats) {
  Scene home = *sound_;
  Node node = home.nodes[first_furniture(home, false)];
  const Bounds room = room_bounds(home.rooms.front(), home.wall_height);
  node.id = "floating_1";
  node.size = Vec3(0.3, 0.3, 0.1);
  node.pose.position = Vec3((room.low.x() + room.high.x()) / 2, (room.low.y() + room.high.y()) / 2, 1.5);
  home.nodes.push_back(node);
  const HomeFinding finding = found(home, HomeFault::Floating);
  EXPECT_EQ(finding.object, "floating_1");
  EXPECT_NEAR(finding.by_m, 1.45, 0.01);
}

TEST_F(HomeFaults, ARoomWithoutADoorIsCutOff) {
  Scene home = *sound_;
  home.openings.clear();
  std::set<std::string> cut_off;
  for (const HomeFinding& finding : faults(home)) {
    if (finding.fault == HomeFault::CutOff) cut_off.insert(finding.object);
  }
  EXPECT_EQ(cut_off.size(), home.rooms.size() - 1) << "all but that where the agent stands";
}

TEST_F(HomeFaults, ADoorThatMeetsAWardrobeIsBlocked) {
  Scene home = *sound_;
  const std::size_t door = first_furniture(home, true);
  Node wardrobe = home.nodes[first_furniture(home, false)];
  wardrobe.id = "before_it_1";
  wardrobe.size = Vec3(0.4, 0.05, 2);
  wardrobe.archetype = Archetype::Box;
  wardrobe.boards.clear();
  wardrobe.pose = home.nodes[door].pose * Pose{Vec3(0, -home.nodes[door].size.y() / 2 - 0.1, 0), Quat::Identity()};
  wardrobe.pose.position.z() = 1;
  home.nodes.push_back(wardrobe);
  const HomeFinding finding = found(home, HomeFault::Blocked);
  EXPECT_EQ(finding.object, home.nodes[door].id);
  EXPECT_EQ(finding.other, "before_it_1");
}

TEST_F(HomeFaults, ACategoryOfNobodyIsUnknown) {
  Scene home = *sound_;
  home.nodes.edit(0).category = "Flumbus";
  EXPECT_EQ(found(home, HomeFault::UnknownCategory).object, home.nodes[0].id);
}

TEST_F(HomeFaults, NothingIsWrongWithTheHomeThatTheyAreMadeOf) { EXPECT_THAT(faults(*sound_), IsEmpty()); }

TEST(HomeFaultNames, AreThoseOfTheSchemaInItsOrder) {
  const auto text = read_file(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/schemas/scene-doctor.schema.json");
  ASSERT_TRUE(text);
  std::size_t at = text->find("\"fault\": {\"enum\": [");
  ASSERT_NE(at, std::string::npos);
  for (int i = 0; i <= static_cast<int>(HomeFault::UnknownCategory); ++i) {
    at = text->find('"' + std::string(name_of(static_cast<HomeFault>(i))) + '"', at);
    ASSERT_NE(at, std::string::npos) << i;
  }
}

}  // namespace
}  // namespace unietp
