#include "grounding/home_traits.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

const std::set<std::string> kTypes{"kitchen", "bedroom"};

Node node(std::string id, std::string category, bool movable, Vec3 at, Vec3 size, double yaw = 0) {
  Node one;
  one.id = std::move(id);
  one.category = std::move(category);
  one.movable = movable;
  one.pose = upright(at, yaw);
  one.size = size;
  return one;
}

/// A kitchen of 4 m by 3 m with two chairs that face each other, a cupboard at the wall with a mug inside and a shoe on
/// the floor; a corridor that does not count; behind it a bedroom.
Scene home_of_three_rooms() {
  Scene home;
  home.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}},
                {"corridor_1", "corridor", {{4, 0}, {6, 0}, {6, 3}, {4, 3}}},
                {"bedroom_1", "bedroom", {{6, 0}, {10, 0}, {10, 3}, {6, 3}}}};
  home.openings = {{"o1", "kitchen_1", "corridor_1", {4, 1}, {4, 2}},
                   {"o2", "corridor_1", "bedroom_1", {6, 1}, {6, 2}}};
  home.nodes.push_back(node("chair_1", "Chair", false, {1, 1, 0.5}, {0.4, 0.4, 1}, std::numbers::pi / 2));
  home.nodes.push_back(node("chair_2", "Chair", false, {2, 1, 0.5}, {0.4, 0.4, 1}, -std::numbers::pi / 2));
  Node cupboard = node("cupboard_1", "Cabinet", false, {2, 2.5, 0.5}, {1, 0.5, 1});
  cupboard.openable = true;
  home.nodes.push_back(std::move(cupboard));
  home.nodes.push_back(node("mug_1", "Mug", true, {2, 2.5, 0.55}, {0.1, 0.1, 0.1}));
  home.nodes.push_back(node("shoe_1", "Shoe", true, {3.5, 0.5, 0.05}, {0.1, 0.1, 0.1}));
  home.nodes.push_back(node("rug_1", "Rug", false, {7, 1, 0.01}, {1, 1, 0.02}));
  home.edges = {{Predicate::Inside, "mug_1", "cupboard_1"}, {Predicate::OnFloor, "shoe_1", "kitchen_1"}};
  return home;
}

std::size_t number(const std::string& name) {
  for (std::size_t i = 0; i < home_traits().size(); ++i) {
    if (home_traits()[i].first == name) return i;
  }
  ADD_FAILURE() << name;
  return 0;
}

TEST(HomeTraits, AreReadFromRoomsFurnitureAndOpenings) {
  const HomeTraits traits = traits_of(home_of_three_rooms(), {"Rug"}, kTypes);
  const auto of = [&](const std::string& name) -> const TraitSample& { return traits.samples.at(number(name)); };
  EXPECT_EQ(traits.rooms, 2);
  EXPECT_THAT(of("rooms by type").counts, UnorderedElementsAre(Pair("kitchen", 1), Pair("bedroom", 1)));
  EXPECT_THAT(of("area of a room").values, ElementsAre(12, 12));
  EXPECT_TRUE(of("joined rooms").counts.empty()) << "the corridor does not count";
  EXPECT_THAT(of("things by room").counts, UnorderedElementsAre(Pair("kitchen/Chair", 2), Pair("kitchen/Cabinet", 1),
                                                                Pair("kitchen/Mug", 1), Pair("kitchen/Shoe", 1)));
  EXPECT_THAT(of("things by receptacle").counts, UnorderedElementsAre(Pair("Cabinet", 1)));
  EXPECT_THAT(of("furniture per m²").values, ElementsAre(0.25, 0));
  ASSERT_EQ(of("furniture to wall").values.size(), 3u);
  EXPECT_NEAR(of("furniture to wall").values[0], 0.8, 1e-9);
  EXPECT_NEAR(of("furniture to wall").values[2], 0.25, 1e-9);
  EXPECT_NEAR(of("turned to the middle").values[2], 1, 1e-9) << "the cupboard at the back wall looks at the middle";
  EXPECT_THAT(of("facing pairs in a room").values, ElementsAre(1, 0));
  ASSERT_EQ(of("height of small things").values.size(), 2u);
  EXPECT_NEAR(of("height of small things").values[0], 0.5, 1e-9);
  EXPECT_THAT(of("small things on floors").values, ElementsAre(0.5));
  ASSERT_EQ(of("way between rooms").values.size(), 1u);
  EXPECT_NEAR(of("way between rooms").values[0], 6, 1e-9) << "through the corridor";
  EXPECT_THAT(of("containers in use").values, ElementsAre(1));
  EXPECT_THAT(of("repeats of a category").values, ElementsAre(1, 2, 1, 1));
  EXPECT_THAT(of("common pairs").counts, ::testing::Contains(Pair("Chair+Mug", 1)));
  ASSERT_EQ(of("free floor").values.size(), 2u);
  EXPECT_LT(of("free floor").values[0], 0.95);
  EXPECT_EQ(of("free floor").values[1], 1);
}

TEST(HomeTraits, AreNoDistanceApartInTheSameHomesAndGrowWithWhatIsMoved) {
  const HomeTraits one = traits_of(home_of_three_rooms(), {}, {"kitchen", "bedroom", "corridor"});
  Scene moved = home_of_three_rooms();
  moved.nodes.edit(0).pose.position.x() -= 0.5;
  const HomeTraits other = traits_of(moved, {}, {"kitchen", "bedroom", "corridor"});
  const std::vector<const HomeTraits*> a{&one}, b{&other};
  for (std::size_t trait = 0; trait < home_traits().size(); ++trait) {
    const auto none = trait_distance(trait, a, a);
    ASSERT_TRUE(none) << home_traits()[trait].first;
    EXPECT_NEAR(*none, 0, 1e-12) << home_traits()[trait].first;
  }
  // A chair stands 0.5 m nearer to the wall, one of four pieces: a quarter of 0.5 m.
  EXPECT_NEAR(*trait_distance(number("furniture to wall"), a, b), 0.125, 1e-9);
}

TEST(HomeComparison, TakesRealHomesOfLikeSizeInEqualSamples) {
  const HomeTraits three = traits_of(home_of_three_rooms(), {}, {"kitchen", "bedroom", "corridor"});
  const HomeTraits two = traits_of(home_of_three_rooms(), {}, kTypes);
  const auto none = compare_homes(std::vector{three}, std::vector{two, two});
  EXPECT_EQ(none.real, 0);
  EXPECT_FALSE(none.traits.front().made);
  Scene wide = home_of_three_rooms();
  for (Room& room : wide.rooms) {
    for (Vec2& corner : room.polygon) corner.y() *= 2;
  }
  const HomeTraits larger = traits_of(wide, {}, kTypes);
  const auto some = compare_homes(std::vector{larger, larger, larger}, std::vector{two, three, two, two, two});
  EXPECT_EQ(some.made, 3);
  EXPECT_EQ(some.real, 4);
  EXPECT_EQ(some.sample, 2);
  const TraitComparison& area = some.traits.at(number("area of a room"));
  EXPECT_NEAR(area.made.value(), 12, 1e-9) << "24 m² against 12 m²";
  EXPECT_NEAR(area.halves.value(), 0, 1e-9);
}

}  // namespace
}  // namespace unietp
