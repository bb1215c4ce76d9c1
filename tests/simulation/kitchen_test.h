#pragma once

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "simulation/feedback.h"
#include "simulation/world.h"

namespace unietp::testing {

/// A world in one of the kitchens of kitchen.h in which a test acts step by step.
class KitchenTest : public ::testing::Test {
 protected:
  KitchenTest(Knowledge knowledge, Profile profile, Scene scene)
      : knowledge_(std::move(knowledge)), profile_(std::move(profile)), scene_(std::move(scene)) {}

  World start(Scene scene) {
    auto world = World::create(std::move(scene), knowledge_, profile_);
    EXPECT_TRUE(world);
    return std::move(*world);
  }
  World start() { return start(scene_); }
  void expect(World& world, ActionType type, const std::string& id = "") {
    const ActionResult outcome = world.step(action(type, id));
    EXPECT_TRUE(outcome.success) << to_text(action(type, id)) << ": " << name_of(outcome.failure) << ": "
                                 << feedback_with_ids(outcome.detail);
  }
  /// A failure names its kind, says something, and changes nothing.
  void expect_failure(World& world, ActionType type, const std::string& id, Failure failure) {
    const Scene before = world.scene();
    const ActionResult outcome = world.step(action(type, id));
    EXPECT_FALSE(outcome.success) << to_text(action(type, id));
    EXPECT_EQ(name_of(outcome.failure), name_of(failure)) << feedback_with_ids(outcome.detail);
    EXPECT_NE(outcome.detail.cause, FailureCause::None);
    EXPECT_TRUE(world.scene() == before);
  }
  static Action action(ActionType type, const std::string& id) {
    return {type, id.empty() ? std::vector<std::string>{} : std::vector<std::string>{id}};
  }
  static bool is(const World& world, const char* id, Predicate predicate) {
    return find_node(world.scene(), id)->states.has(predicate);
  }
  static bool is(const World& world, const char* id, Predicate predicate, const char* symbol) {
    return find_node(world.scene(), id)->states.has(State{predicate, symbol});
  }

  Knowledge knowledge_;
  Profile profile_;
  Scene scene_;
};

}  // namespace unietp::testing
