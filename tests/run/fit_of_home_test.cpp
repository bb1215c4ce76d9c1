#include "run/fit_of_home.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "../resources/committed.h"

namespace unietp {
namespace {

/// Of the first homes of a run, one with a sink in the kitchen and one in a bathroom.
const Layout* with_two_sinks(LayoutPool& layouts) {
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
    if (in("kitchen") && in("bathroom")) return &*layout;
  }
  return nullptr;
}

TEST(FitOfHome, NoDishesGoIntoASinkThatMayBeThatOfABathroom) {
  RunConfiguration configuration;
  configuration.rooms = 7;
  configuration.objects = 60;
  LayoutPool layouts(configuration, committed(), 6);
  const Layout* layout = with_two_sinks(layouts);
  ASSERT_NE(layout, nullptr);
  const auto suits = [&](const std::string& text) {
    const auto goal = parse_formula("goal", text, FormulaUse::Goal);
    EXPECT_TRUE(goal) << text;
    return goal && all_sinks_suit(*goal, *layout, *committed().recipe(Simulator::Ai2thor).household);
  };
  EXPECT_FALSE(suits("(exists (?a - Plate) (exists (?b - Sink) (at-end (inside ?a ?b))))"));
  EXPECT_TRUE(suits("(exists (?a - SoapBar) (exists (?b - Sink) (at-end (inside ?a ?b))))"));
  EXPECT_TRUE(suits("(exists (?a - Plate) (exists (?b - Cabinet) (at-end (inside ?a ?b))))"))
      << "people find the cabinet of the kitchen";
  EXPECT_TRUE(
      suits("(exists (?a - Plate) (exists (?b - (Sink :where (exists (?r - kitchen) (in_room ?b ?r)))) (at-end (inside "
            "?a ?b))))"))
      << "it says which";
}

}  // namespace
}  // namespace unietp
