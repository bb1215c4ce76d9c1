#include "run/layout_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../resources/committed.h"
#include "run/slots.h"

namespace unietp {
namespace {

Scene home_with_a_mug(const std::string& id) {
  Scene home;
  home.id = id;
  home.simulator = Simulator::Habitat;
  home.rooms = {{"kitchen_1", "kitchen", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}}};
  Node mug;
  mug.id = "mug_1";
  mug.category = "Mug";
  mug.size = {0.1, 0.1, 0.1};
  home.nodes = {mug};
  return home;
}

TEST(LayoutPool, GivesEqualHomesWhoeverAsksFirst) {
  RunConfiguration configuration;
  configuration.rooms = 5;
  configuration.objects = 10;
  LayoutPool forwards(configuration, committed(), 2), backwards(configuration, committed(), 2);
  const auto& first = forwards.layout(Simulator::Ai2thor, 0);
  (void)backwards.layout(Simulator::Ai2thor, 1);
  const auto& again = backwards.layout(Simulator::Ai2thor, 0);
  ASSERT_TRUE(first && again);
  EXPECT_EQ(first->home.scene, again->home.scene);
  EXPECT_EQ(first->offer.categories, again->offer.categories);
  EXPECT_NE(first->home.scene, forwards.layout(Simulator::Ai2thor, 1)->home.scene);
}

TEST(LayoutPool, UsesGivenHomesInPlaceOfDrawnOnes) {
  Category mug;
  mug.name = "Mug";
  mug.movable = true;
  Resources resources;
  for (const auto simulator : kSimulators) {
    Knowledge knowledge(simulator, {mug}, {}, {}, {}, {});
    NounTable nouns(knowledge, {});
    resources.backends.push_back({std::move(knowledge), Profile{}, std::move(nouns)});
  }
  resources.homes = {home_with_a_mug("first"), home_with_a_mug("second")};
  const RunConfiguration configuration;
  LayoutPool pool(configuration, resources, 1);
  ASSERT_EQ(pool.size(Simulator::Habitat), 2);
  const auto& layout = pool.layout(Simulator::Habitat, 1);
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->home.scene.id, "second");
  EXPECT_EQ(layout->home.scene.nodes, resources.homes[1].nodes);
  EXPECT_THAT(layout->offer.categories, ::testing::Contains("Mug"));
  const auto slots = plan_slots(configuration, resources);
  ASSERT_FALSE(slots);
  EXPECT_THAT(slots.error().message, ::testing::HasSubstr("none of the given scenes belongs to ai2thor"));
}

}  // namespace
}  // namespace unietp
