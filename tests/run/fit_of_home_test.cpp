#include "run/fit_of_home.h"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "../resources/committed.h"

namespace unietp {
namespace {

/// Of the first homes of a run, one with a sink in the kitchen and one in a bathroom.
std::optional<Layout> home_with_two_sinks() {
  RunConfiguration configuration;
  configuration.rooms = 7;
  configuration.objects = 60;
  LayoutPool layouts(configuration, committed(), 6);
  for (int number = 0; number < layouts.size(Simulator::Ai2thor); ++number) {
    const auto& layout = layouts.layout(Simulator::Ai2thor, number);
    if (!layout) continue;
    const Home& home = layout->home;
    const auto in = [&](const std::string& type) {
      const auto& sinks = home.places.of("Sink");
      return std::any_of(sinks.begin(), sinks.end(), [&](std::size_t sink) {
        return home.rooms[sink] >= 0 && home.scene.rooms[static_cast<std::size_t>(home.rooms[sink])].type == type;
      });
    };
    if (in("kitchen") && in("bathroom")) return *layout;
  }
  return std::nullopt;
}

TEST(FitOfHome, NoDishesGoIntoASinkThatMayBeThatOfABathroom) {
  const auto layout = home_with_two_sinks();
  ASSERT_TRUE(layout);
  const auto suits = [&](const std::string& text) {
    const auto goal = parse_formula("goal", text, FormulaUse::Goal);
    EXPECT_TRUE(goal) << text;
    return goal && all_sinks_suit(*goal, *layout, *committed().recipe(Simulator::Ai2thor).household);
  };
  EXPECT_FALSE(suits("(exists (?a - Plate) (exists (?b - Sink) (at-end (inside ?a ?b))))"));
  EXPECT_TRUE(suits("(exists (?a - SoapBottle) (exists (?b - Sink) (at-end (inside ?a ?b))))"));
  EXPECT_TRUE(suits("(exists (?a - Plate) (exists (?b - Cabinet) (at-end (inside ?a ?b))))"))
      << "people find the cabinet of the kitchen";
  EXPECT_TRUE(
      suits("(exists (?a - Plate) (exists (?b - (Sink :where (exists (?r - kitchen) (in_room ?b ?r)))) (at-end (inside "
            "?a ?b))))"))
      << "it says which";
}

TEST(LeavesOpen, WhichOfSeveralPlacesInSeveralRoomsAndWhosePhone) {
  const auto layout = home_with_two_sinks();
  ASSERT_TRUE(layout);
  Layout home = *layout;
  const Household& household = *committed().recipe(Simulator::Ai2thor).household;
  const NounTable& nouns = committed().backend(Simulator::Ai2thor).nouns;
  const auto open = [&](const std::string& text) {
    const auto goal = parse_formula("goal", text, FormulaUse::Goal);
    EXPECT_TRUE(goal) << text;
    return goal && leaves_open(*goal, home, household, nouns);
  };
  const std::string sink = "(exists (?a - Sink) (at-end (clean ?a)))";
  EXPECT_TRUE(open(sink));
  EXPECT_FALSE(open("(exists (?b - (Sink :where (exists (?r - kitchen) (in_room ?b ?r)))) (at-end (clean ?b)))"));
  EXPECT_FALSE(open("(exists (?a - Fridge) (at-end (open ?a)))"));
  auto& nodes = home.home.scene.nodes;
  std::vector<std::size_t> carried;
  for (std::size_t i = 0; i < nodes.size() && carried.size() < 2; ++i)
    if (nodes[i].movable) carried.push_back(i);
  ASSERT_EQ(carried.size(), 2U);
  for (const char* category : {"CellPhone", "Mug"}) {
    for (const std::size_t at : carried) nodes.edit(at).category = category;
    home.home.places = NodeIndex(nodes);
    const bool whose = std::string(category) == "CellPhone";
    EXPECT_EQ(open("(exists (?a - " + std::string(category) + ") (at-end (held ?a)))"), whose) << category;
  }
}

/// "The drawer" could be one of the chest of drawers.
TEST(LeavesOpen, WhichDrawerBesideAChestOfDrawers) {
  const auto layout = home_with_two_sinks();
  ASSERT_TRUE(layout);
  Layout home = *layout;
  auto& nodes = home.home.scene.nodes;
  std::vector<std::size_t> fixed;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!nodes[i].movable) fixed.push_back(i);
  ASSERT_GE(fixed.size(), 2U);
  const auto open_beside = [&](const char* other) {
    for (const std::size_t at : fixed) nodes.edit(at).category = other;
    nodes.edit(fixed[0]).category = "drawer";
    home.home.places = NodeIndex(nodes);
    const auto goal = parse_formula("goal", "(exists (?a - drawer) (at-end (open ?a)))", FormulaUse::Goal);
    EXPECT_TRUE(goal);
    return goal && leaves_open(*goal, home, *committed().recipe(Simulator::Habitat).household,
                               committed().backend(Simulator::Habitat).nouns);
  };
  EXPECT_FALSE(open_beside("bathtub"));
  EXPECT_TRUE(open_beside("chest_of_drawers"));
}

}  // namespace
}  // namespace unietp
