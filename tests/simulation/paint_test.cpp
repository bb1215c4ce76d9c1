#include "simulation/paint.h"

#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace unietp {
namespace {

std::tuple<double, double, double> painted(const std::string& id, const std::string& category,
                                           const std::string& color = "") {
  Node node;
  node.id = id;
  node.category = category;
  node.color = color;
  node.archetype = Archetype::Vessel;
  const Color paint = paint_of(node);
  return {paint.x(), paint.y(), paint.z()};
}

TEST(Paint, VariesWithTheIdAndTheCategory) {
  std::set<std::tuple<double, double, double>> shades, categories;
  for (int i = 1; i <= 20; ++i) shades.insert(painted("mug_" + std::to_string(i), "Mug", "red"));
  for (const char* category : {"Apple", "Book", "Bowl", "Cup", "Fork", "Knife", "Mug", "Pan", "Plate", "Spoon"})
    categories.insert(painted("thing_1", category));
  EXPECT_GE(shades.size(), 8U) << "mugs of one color cannot be told apart";
  EXPECT_GE(categories.size(), 4U) << "small things of all categories look alike";
}

TEST(Paint, IsTheSameOnEveryMachine) {
  EXPECT_EQ(painted("mug_1", "Mug"), painted("mug_1", "Mug"));
  EXPECT_NE(painted("mug_1", "Mug", "red"), painted("mug_1", "Mug", "blue"));
}

}  // namespace
}  // namespace unietp
