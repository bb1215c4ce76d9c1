#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/fresh_id.h"
#include "simulation/feedback.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Does the actions in a fresh world and records them.
Demonstration done(const Scene& start, const Knowledge& knowledge, const Profile& profile,
                   const std::vector<Action>& actions) {
  auto world = World::create(start, knowledge, profile);
  Demonstration demonstration;
  for (const Action& action : actions) {
    const Scene before = world->scene();
    DemonstrationStep step;
    step.action = action;
    step.outcome = outcome_in(Mode::M1, world->step(action));
    EXPECT_TRUE(step.outcome.success) << to_text(action) << ": " << step.outcome.feedback;
    step.changes = difference(before, world->scene());
    demonstration.steps.push_back(std::move(step));
  }
  return demonstration;
}

struct NeedlessSteps : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = house();
  std::vector<std::string> of(const std::string& text, const std::vector<Action>& actions) const {
    return needless_steps(goal(text), start, done(start, knowledge, profile, actions), knowledge, profile);
  }
};

TEST_F(NeedlessSteps, AreNoneWhenEveryStepIsNeeded) {
  EXPECT_THAT(of("(exists (?x - Fridge) (at-end (open ?x)))",
                 {{ActionType::GoTo, {"fridge_1"}}, {ActionType::Open, {"fridge_1"}}, {ActionType::Stop, {}}}),
              IsEmpty());
}

TEST_F(NeedlessSteps, NameADoorClosedOutOfGoodManners) {
  EXPECT_THAT(of("(exists (?x - Fridge) (sometime (open ?x)))", {{ActionType::GoTo, {"fridge_1"}},
                                                                 {ActionType::Open, {"fridge_1"}},
                                                                 {ActionType::Close, {"fridge_1"}},
                                                                 {ActionType::Stop, {}}}),
              Contains("without step 3: close(fridge_1)"));
}

TEST_F(NeedlessSteps, NameAWalkThatLeadsNowhere) {
  EXPECT_THAT(of("(exists (?x - Fridge) (at-end (open ?x)))", {{ActionType::GoTo, {"sidetable_1"}},
                                                               {ActionType::GoTo, {"fridge_1"}},
                                                               {ActionType::Open, {"fridge_1"}},
                                                               {ActionType::Stop, {}}}),
              Contains("without step 1: go_to(sidetable_1)"));
}

TEST_F(NeedlessSteps, NameWhatMightAsWellStayInTheHand) {
  // Without putting the mug down there is no hand for the apple; but the apple may come first.
  const char* cleared =
      "(exists (?x - (Mug :where (exists (?c - CounterTop) (on ?x ?c)))) (exists (?c - CounterTop) (exists (?a - "
      "Apple) "
      "(exists (?t - SideTable) (at-end (and (not (on ?x ?c)) (on ?a ?t)))))))";
  EXPECT_THAT(of(cleared, {{ActionType::GoTo, {"mug_3"}},
                           {ActionType::PickUp, {"mug_3"}},
                           {ActionType::GoTo, {"diningtable_1"}},
                           {ActionType::PlaceOn, {"diningtable_1"}},
                           {ActionType::GoTo, {"apple_1"}},
                           {ActionType::PickUp, {"apple_1"}},
                           {ActionType::GoTo, {"sidetable_1"}},
                           {ActionType::PlaceOn, {"sidetable_1"}},
                           {ActionType::Stop, {}}}),
              Contains("with mug_3 left in the hand"));
  const auto shown = demonstrate(goal(cleared), start, knowledge, profile, {});
  ASSERT_TRUE(std::holds_alternative<Demonstration>(shown));
  EXPECT_THAT(needless_steps(goal(cleared), start, std::get<Demonstration>(shown), knowledge, profile), IsEmpty());
}

TEST_F(NeedlessSteps, NameAnOrderThatDoesNotMatterWhereTheGoalHasOne) {
  // `until (closed fridge) ...` is met by any order when the second part is about something else than the first.
  const std::vector<Action> actions{{ActionType::GoTo, {"lamp_1"}},
                                    {ActionType::TurnOn, {"lamp_1"}},
                                    {ActionType::GoTo, {"laptop_1"}},
                                    {ActionType::TurnOn, {"laptop_1"}},
                                    {ActionType::Stop, {}}};
  EXPECT_THAT(
      of("(exists (?x - Lamp) (exists (?y - Laptop) (exists (?f - Fridge) (and (until (closed ?f) (power_on ?x)) "
         "(at-end (and (power_on ?x) (power_on ?y)))))))",
         actions),
      Contains(HasSubstr("after turn_on(laptop_1)")));
  EXPECT_THAT(
      of("(exists (?x - Lamp) (exists (?y - Laptop) (and (before (power_on ?x) (power_on ?y)) (at-end (power_on "
         "?y)))))",
         actions),
      IsEmpty());
}

TEST_F(NeedlessSteps, CountWhatIsPouredAsAPartOfTheOrder) {
  // That the tap may run before the mug stands under it says nothing about the order of filling and pouring.
  auto affordances = knowledge.affordances();
  for (const auto& [category, affordance] : {std::pair("Mug", "fillable"), std::pair("Sink", "switchable")})
    affordances.push_back({category, affordance, {"curated", 1}});
  auto effects = knowledge.effects();
  effects.push_back(
      {"Sink", Treatment::Fills, "Mug", "water", 0, {EffectNeed::Inside, EffectNeed::UnderTap}, {"curated", 1}});
  const Knowledge wet(Simulator::Ai2thor, knowledge.categories(), affordances, knowledge.placements(), effects, {});
  Scene scene = start;
  for (const char* mug : {"mug_1", "mug_2", "mug_3"}) set_state(scene, mug, Predicate::Empty);
  set_state(scene, "sink_1", Predicate::PowerOff);
  scene.agent.position = {2.8, 2.8};  // where it reaches both the mug and the sink
  const std::vector<Action> actions{
      {ActionType::PickUp, {"mug_3"}}, {ActionType::PlaceIn, {"sink_1"}}, {ActionType::TurnOn, {"sink_1"}},
      {ActionType::PickUp, {"mug_3"}}, {ActionType::GoTo, {"mug_1"}},     {ActionType::PourTo, {"mug_1"}},
      {ActionType::Stop, {}}};
  EXPECT_THAT(needless_steps(goal("(exists (?x - Mug) (exists (?y - Mug) (and (before (filled ?x water) (filled ?y "
                                  "water)) (at-end (filled ?y water)))))"),
                             scene, done(scene, wet, profile, actions), wet, profile),
              IsEmpty());
}

TEST_F(NeedlessSteps, NameADistractorThatWouldDoAsWell) {
  // The second part is what the plan achieves, so which lamp the first part refers to makes no difference.
  const std::vector<Action> actions{
      {ActionType::GoTo, {"apple_1"}}, {ActionType::PickUp, {"apple_1"}}, {ActionType::Stop, {}}};
  EXPECT_THAT(
      of("(exists (?a - Apple) (and (at-end (held ?a)) (not (exists (?x - (Apple :where (exists (?c - CounterTop) "
         "(on ?x ?c)))) (sometime (sliced ?x))))))",
         actions),
      IsEmpty());
  EXPECT_THAT(of("(and (exists (?a - Apple) (at-end (held ?a))) (not (exists (?x - (Apple :where (exists (?c - "
                 "DiningTable) (on ?x ?c)))) (sometime (sliced ?x)))))",
                 actions),
              Contains("with apple_2 instead of apple_1"));
}

TEST_F(NeedlessSteps, TryTheEightNearestOfManyDistractors) {
  Scene scene = house();
  for (int i = 0; i < 12; ++i) add(scene, knowledge, fresh_id(scene, "Mug"), "Mug", 3.3 + 0.12 * i, 0.3, 0.001);
  edit_node(scene, "mug_4")->states.set({Predicate::Hot, {}});
  const std::vector<Action> actions{
      {ActionType::GoTo, {"mug_4"}}, {ActionType::PickUp, {"mug_4"}}, {ActionType::Stop, {}}};
  // Any mug would do; the hot one at the row's end is no more than spoken of.
  const auto surviving =
      needless_steps(goal("(and (exists (?a - Mug) (at-end (held ?a))) (not (exists (?x - (Mug :where "
                          "(hot ?x))) (sometime (sliced ?x)))))"),
                     scene, done(scene, knowledge, profile, actions), knowledge, profile);
  EXPECT_THAT(surviving, Contains("with mug_5 instead of mug_4"));
  EXPECT_THAT(surviving, Contains("with mug_12 instead of mug_4"));
  EXPECT_THAT(surviving, Not(Contains("with mug_13 instead of mug_4")));
}

}  // namespace
}  // namespace unietp::testing
