#include "grounding/scene_statistics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

CensusRoom kitchen_with(std::vector<CensusObject> objects) {
  return {"kitchen", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, std::move(objects)};
}
CensusObject piece(std::string category, double width, double height, double bottom = 0) {
  return {std::move(category), false, Bounds{{0, 0, bottom}, {width, 1, bottom + height}}, {}};
}
CensusObject thing(std::string category, std::vector<std::string> held_by = {}) {
  return {std::move(category), true, std::nullopt, std::move(held_by)};
}

TEST(SceneStatistics, CountsPerRoomOfATypeAndPerHome) {
  const HomeCensus one{{kitchen_with({piece("Fridge", 1, 2), thing("Mug", {"Fridge"}), thing("Mug")}),
                        kitchen_with({thing("Apple")}),
                        {"bedroom", {}, {piece("Bed", 2, 1)}}}};
  const auto s = statistics_of(std::vector{one, HomeCensus{{kitchen_with({})}}}, "test");
  EXPECT_EQ(s.homes, 2);
  EXPECT_EQ(s.rooms, 4);
  EXPECT_DOUBLE_EQ(s.rooms_per_home, 2);
  EXPECT_DOUBLE_EQ(s.objects_per_home, 2.5);
  EXPECT_DOUBLE_EQ(s.movable_share, 0.6);
  EXPECT_DOUBLE_EQ(s.rooms_of_type.at("kitchen"), 1.5);
  EXPECT_DOUBLE_EQ(s.objects_in.at("kitchen"), 4.0 / 3);
  EXPECT_DOUBLE_EQ((s.movables.at({"kitchen", "Mug"})), 2.0 / 3);
  EXPECT_DOUBLE_EQ((s.furniture.at({"bedroom", "Bed"})), 1);
  EXPECT_DOUBLE_EQ((s.together.at({"Fridge", "Mug"})), 0.25);
  EXPECT_DOUBLE_EQ(s.held.at("Fridge"), 1);
  EXPECT_DOUBLE_EQ(s.area_m2.at("kitchen"), 12);
  EXPECT_FALSE(s.area_m2.contains("bedroom")) << "no outline, no area";
}

TEST(SceneStatistics, FloorIsFreeWhereNothingStandsLowAndHigh) {
  EXPECT_DOUBLE_EQ(*free_floor_share(kitchen_with({})), 1);
  EXPECT_NEAR(*free_floor_share(kitchen_with({piece("Fridge", 3, 2)})), 0.75, 1e-9);
  EXPECT_DOUBLE_EQ(*free_floor_share(kitchen_with({piece("Rug", 3, 0.02), piece("Shelf", 3, 0.4, 1.4)})), 1);
  EXPECT_FALSE(free_floor_share({"kitchen", {}, {}}));
}

TEST(StatisticsDistance, IsZeroForTheSameAndOneForNothingInCommon) {
  const HomeCensus a{{kitchen_with({piece("Fridge", 1, 2), piece("Sink", 1, 1), thing("Mug", {"Sink"})})}};
  const HomeCensus b{{kitchen_with({piece("Oven", 1, 2), piece("Table", 1, 1), thing("Apple", {"Table"})})}};
  const auto of_a = statistics_of(std::vector{a}, "a"), of_b = statistics_of(std::vector{b}, "b");
  for (const auto& [name, part] : parts_of(distance(of_a, of_a))) {
    ASSERT_TRUE(part) << name;
    EXPECT_NEAR(*part, 0, 1e-12) << name;
  }
  const StatisticsDistance apart = distance(of_a, of_b);
  EXPECT_NEAR(*apart.furniture, 1, 1e-12);
  EXPECT_NEAR(*apart.movables_in_room, 1, 1e-12);
  EXPECT_NEAR(*apart.held, 1, 1e-12);
  EXPECT_NEAR(*apart.together, 1, 1e-12);
  EXPECT_NEAR(*apart.room_types, 0, 1e-12);
}

TEST(StatisticsDistance, IsSymmetricAndSaysNothingWhereASetCannot) {
  const HomeCensus with_floor{{kitchen_with({piece("Fridge", 1, 2), piece("Fridge", 1, 2), piece("Sink", 1, 1)})}};
  HomeCensus without = with_floor;
  without.rooms.front().outline.clear();
  without.rooms.front().objects.pop_back();
  const auto a = statistics_of(std::vector{with_floor}, "a"), b = statistics_of(std::vector{without}, "b");
  EXPECT_FALSE(distance(a, b).free_floor);
  EXPECT_FALSE(distance(a, b).movables);
  EXPECT_DOUBLE_EQ(*distance(a, b).furniture, *distance(b, a).furniture);
  // p = (2/3, 1/3), q = (1, 0): (log2(4/5) * 2/3 + 1/3 * log2(2) + log2(6/5)) / 2.
  EXPECT_NEAR(*distance(a, b).furniture, 0.1908745, 1e-6);
}

TEST(SceneStatistics, ReadsBackWhatItWrote) {
  const HomeCensus home{{kitchen_with({piece("Fridge", 1, 2), thing("Mug", {"Fridge"})})}};
  const auto s = statistics_of(std::vector{home}, "one \"home\"");
  const auto again = statistics_from_json("a.json", statistics_to_json(s));
  ASSERT_TRUE(again) << format(again.error());
  EXPECT_EQ(statistics_to_json(*again), statistics_to_json(s)) << "to four decimals";
  EXPECT_EQ(again->furniture, s.furniture);
  EXPECT_THAT(statistics_text(s), ::testing::HasSubstr("Fridge 1"));
}

TEST(StatisticsFromJson, SaysWhereTheTextIsWrong) {
  const auto error = [](std::string_view text) {
    const auto read = statistics_from_json("a.json", text);
    return read ? "no error" : format(read.error());
  };
  EXPECT_THAT(error("{"), ::testing::HasSubstr("a.json:1:2: parse error"));
  EXPECT_THAT(error(R"({"format":"unietp-scene-statistics/1"})"), ::testing::HasSubstr("source"));
  EXPECT_THAT(error(R"({"format":"x","source":"s"})"), ::testing::HasSubstr("expected unietp-scene-statistics/1"));
  const std::string sound = statistics_to_json(statistics_of(std::span<const HomeCensus>(), "none"));
  std::string bad = sound;
  bad.replace(bad.find("\"held\": []"), 10, "\"held\": [[\"Sink\"]]");
  EXPECT_THAT(error(bad), ::testing::HasSubstr("/held/0: schema error: expected a list of 2"));
}

}  // namespace
}  // namespace unietp
