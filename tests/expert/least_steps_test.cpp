#include "expert/least_steps.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "expert/goal_reading.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

struct LeastSteps : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();

  /// Of the way to the goal that asks for the fewest.
  std::size_t least(const std::string& text, const Scene& start) const {
    const Formula formula = goal(text);
    auto executions = ExecutionTree::of(formula, start, knowledge, profile);
    const Situation situation = look_around(*executions, Mode::M1);
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const Alternative& way : read_goal(formula, situation, {}))
      least = std::min(least, least_steps(Attempt(*executions, situation, way, {})));
    return least;
  }
};

TEST_F(LeastSteps, CountsWhatEachThingNeedsOfItsOwn) {
  EXPECT_EQ(least("(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))", house()), 2U);
  EXPECT_EQ(least("(exists (?y - SideTable) (forall (?x - Mug) (at-end (on ?x ?y))))", house()), 6U);
  EXPECT_EQ(least("(exists (?x - Potato) (at-end (hot ?x)))", house()), 2U);
  EXPECT_EQ(least("(exists (?x - Fridge) (at-end (open ?x)))", house()), 0U);
}

TEST_F(LeastSteps, CountsAWalkForEachThingThatIsOutOfReachOfTheOthers) {
  Scene scene = house();
  scene.rooms.back().polygon[1].x() += 20, scene.rooms.back().polygon[2].x() += 20;
  add(scene, knowledge, "countertop_9", "CounterTop", 18, 2, 0);
  add(scene, knowledge, "mug_9", "Mug", 18, 2, 1);
  EXPECT_EQ(least("(exists (?y - SideTable) (forall (?x - Mug) (at-end (on ?x ?y))))", at_rest(std::move(scene))), 9U);
}

TEST_F(LeastSteps, EndsWhereTwoThingsRestOnEachOther) {
  // As in a home from a file: two mugs in one place, each in the other.
  Scene scene = house();
  erase_if(scene.nodes, [](const Node& node) { return node.category == "Mug"; });
  for (const char* id : {"mug_1", "mug_2"}) {
    add(scene, knowledge, id, "Mug", 8.5, 3.5, 0);
    move_to(scene, id, 8.5, 3.5, 0.602);
  }
  const World world = *World::create(scene, knowledge, profile);
  ASSERT_EQ(world.linked_from("mug_1", Predicate::Inside), std::vector<std::string>{"mug_2"});
  ASSERT_EQ(world.linked_from("mug_2", Predicate::Inside), std::vector<std::string>{"mug_1"});
  EXPECT_EQ(least("(exists (?x - Mug) (at-end (hot ?x)))", scene), 2U);
}

/// What it says cannot be done in fewer steps is done in no fewer.
TEST_F(LeastSteps, AreNoMoreThanTheExpertTakesInAnyHouse) {
  const char* const goals[] = {
      "(forall (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))",
      "(exists (?y - DiningTable) (forall (?x - Plate) (at-end (on ?x ?y))))",
      "(exists (?y - CounterTop) (at-end (count >= 2 (?x - Apple) (on ?x ?y))))",
      "(forall (?x - Mug) (at-end (clean ?x)))",
      "(forall (?x - Plate) (at-end (clean ?x)))",
      "(forall (?x - Potato) (at-end (hot ?x)))",
      "(exists (?x - Mug) (at-end (and (clean ?x) (cool ?x))))",
      "(exists (?b - DiningTable) (forall (?x - Potato) (at-end (and (hot ?x) (on ?x ?b)))))",
      "(exists (?f - Fridge) (forall (?x - Apple) (at-end (and (inside ?x ?f) (closed ?f)))))",
      "(exists (?x - Mug) (exists (?y - Apple) (at-end (and (held ?x) (sliced ?y)))))",
  };
  int met = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Scene start = strewn_house(Rng(seed));
    if (seed % 2 == 0) all_dirty(start);
    for (const char* text : goals) {
      SCOPED_TRACE(text);
      const auto made = demonstrate(goal(text), start, knowledge, profile, {});
      if (std::holds_alternative<Rejection>(made)) continue;
      const auto& steps = std::get<Demonstration>(made).steps;
      EXPECT_LT(least(text, start), steps.size());
      ++met;
    }
  }
  EXPECT_GT(met, 20);
}

}  // namespace
}  // namespace unietp::testing
