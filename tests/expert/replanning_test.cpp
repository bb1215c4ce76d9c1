#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/fresh_id.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Replanning : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();

  Demonstration plan(const std::string& text, const Scene& start) const {
    const Formula formula = goal(text);
    auto result = demonstrate(formula, start, knowledge, profile, {});
    if (const auto* rejection = std::get_if<Rejection>(&result)) {
      ADD_FAILURE() << name_of(rejection->reason) << ": " << rejection->detail;
      return {};
    }
    EXPECT_EQ(replay(formula, start, std::get<Demonstration>(result), knowledge, profile), "");
    return std::get<Demonstration>(result);
  }
  Rejection refusal(const std::string& text, const Scene& start, const ExpertOptions& options = {}) const {
    const auto result = demonstrate(goal(text), start, knowledge, profile, options);
    if (const auto* rejection = std::get_if<Rejection>(&result)) return *rejection;
    ADD_FAILURE() << plan_of(std::get<Demonstration>(result));
    return {};
  }
};

/// The side table by the lamp is nearer to the mugs than the other one; boxes leave no room on it.
Scene with_a_full_table(const std::string& full) {
  Scene scene = house();
  erase_if(scene.nodes, [](const Node& n) {
    return n.category == "Lamp" || n.category == "Laptop" || n.id == "plate_2" || n.category == "Box";
  });
  const Vec3 middle = find_node(scene, full)->pose.position;
  const Knowledge knowledge = house_knowledge();
  int count = 0;
  for (const double dx : {-0.15, 0.15}) {
    for (const double dy : {-0.15, 0.15}) {
      add(scene, knowledge, "box_" + std::to_string(++count), "Box", middle.x() + dx, middle.y() + dy, 0.601);
    }
  }
  return at_rest(std::move(scene));
}

TEST_F(Replanning, TakesAnotherPlaceWhenTheFirstIsFull) {
  const std::string text = "(exists (?x - Plate) (exists (?y - SideTable) (at-end (on ?x ?y))))";
  const std::string free_one = plan_of(plan(text, with_a_full_table("sidetable_1")));
  const std::string free_two = plan_of(plan(text, with_a_full_table("sidetable_2")));
  EXPECT_THAT(free_one, HasSubstr("place_on(sidetable_2)"));
  EXPECT_THAT(free_two, HasSubstr("place_on(sidetable_1)"));
}

TEST_F(Replanning, LearnsWhichOfManyChoicesWasWrong) {
  // A row of mugs on the floor, all nearer to the full table than to the other: more ways than there are attempts.
  Scene scene = with_a_full_table("sidetable_2");
  for (int i = 0; i < 12; ++i) add(scene, knowledge, fresh_id(scene, "Mug"), "Mug", 3.3 + 0.12 * i, 0.3, 0.001);
  scene = at_rest(std::move(scene));
  const std::string text =
      "(exists (?d - SideTable) (exists (?x - Mug) (exists (?y - Apple) (at-end (and (on ?x ?d) (on ?y ?d))))))";
  EXPECT_THAT(plan_of(plan(text, scene)), HasSubstr("place_on(sidetable_1)"));
}

TEST_F(Replanning, TakesAnotherObjectWhenTheFirstCannotBeReached) {
  Scene scene = house();
  // Shut into a fridge whose door a counter blocks; still the nearest apple.
  Node& apple = *edit_node(scene, "apple_1");
  apple.pose.position = Vec3(4.4, 3.55, 0.95);
  const Knowledge k = house_knowledge();
  add(scene, k, "countertop_2", "CounterTop", 4.2, 2.7, 0);
  scene = at_rest(std::move(scene));
  const std::string steps = plan_of(plan("(exists (?x - Apple) (at-end (held ?x)))", scene));
  EXPECT_THAT(steps, HasSubstr("pick_up(apple_2)"));
}

TEST_F(Replanning, TakesAnotherToolWhenTheFirstFails) {
  Scene scene = house();
  const Knowledge k = house_knowledge();
  const std::string text = "(exists (?x - (Plate :where (dirty ?x))) (at-end (clean ?x)))";
  add(scene, k, "sink_2", "Sink", 0.5, 3.6, 0);
  EXPECT_THAT(plan_of(plan(text, at_rest(scene))), HasSubstr("wash_with(sink_1)"));
  for (int i = 0; i < 2; ++i) add(scene, k, "box_" + std::to_string(i + 2), "Box", 3.07 + 0.26 * i, 3.6, 0.95, 1.5708);
  EXPECT_THAT(plan_of(plan(text, at_rest(scene))), HasSubstr("wash_with(sink_2)"));
}

TEST_F(Replanning, SaysWhyThereIsNoPlan) {
  const Scene scene = house();
  EXPECT_EQ(refusal("(exists (?x - Fridge) (at-end (held ?x)))", scene).reason, RejectionReason::NoPlan);
  EXPECT_EQ(stage_of(refusal("(exists (?x - Mug) (and (always (dirty ?x)) (at-end (clean ?x))))", scene).reason),
            RejectionStage::Expert);
  EXPECT_EQ(
      refusal("(exists (?x - Mug) (exists (?y - Fridge) (at-end (inside ?x ?y))))", scene, {.max_steps = 3}).reason,
      RejectionReason::TooManySteps);
  EXPECT_EQ(
      refusal("(exists (?x - Apple) (exists (?f - Fridge) (and (always (closed ?f)) (at-end (inside ?x ?f)))))", scene)
          .reason,
      RejectionReason::ActionFailed);
}

TEST_F(Replanning, TriesNothingThatNeedsMoreStepsThanThereAre) {
  const std::string goal = "(forall (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))";
  const Rejection refused = refusal(goal, house(), {.max_steps = 6});
  EXPECT_EQ(refused.reason, RejectionReason::TooManySteps);
  EXPECT_THAT(refused.detail, HasSubstr("needs 7 steps or more, and 6 are allowed"));
  EXPECT_THAT(refusal(goal, house(), {.max_steps = 7}).detail, HasSubstr("needs more than 7 steps"));
}

TEST_F(Replanning, GivesUpAfterTooManyFailures) {
  EXPECT_EQ(refusal("(exists (?x - Apple) (exists (?f - Fridge) (and (always (closed ?f)) (at-end (inside ?x ?f)))))",
                    house(), {.max_failures = 0})
                .reason,
            RejectionReason::TooManyFailures);
}

TEST_F(Replanning, EqualArgumentsGiveEqualDemonstrations) {
  const Scene scene = house();
  const std::string text = "(exists (?b - SideTable) (forall (?x - Mug) (at-end (on ?x ?b))))";
  const Demonstration a = plan(text, scene), b = plan(text, scene);
  ASSERT_EQ(a.steps.size(), b.steps.size());
  for (std::size_t i = 0; i < a.steps.size(); ++i) {
    EXPECT_EQ(a.steps[i].action, b.steps[i].action);
    EXPECT_EQ(a.steps[i].changes, b.steps[i].changes);
    EXPECT_EQ(a.steps[i].visible, b.steps[i].visible);
  }
}

TEST_F(Replanning, AGoalThatHoldsAlreadyNeedsOnlyStop) {
  EXPECT_EQ(plan_of(plan("(exists (?x - Fridge) (at-end (closed ?x)))", house())), "stop ");
}

}  // namespace
}  // namespace unietp::testing
