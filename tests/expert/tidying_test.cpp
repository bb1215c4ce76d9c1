#include "expert/tidying.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "expert/execution.h"
#include "expert/mode_expert.h"
#include "expert/rollout.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::IsEmpty;

struct Tidying : ::testing::TestWithParam<Mode> {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene start = house();
  Formula wanted;

  /// The demonstration of a goal about a mug that stands in the fridge.
  Demonstration shown(const std::string& text) {
    wanted = goal(text);
    mug_in_fridge(start);
    start = at_rest(start);
    auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
    auto in_m1 = demonstrate(executions, {});
    EXPECT_TRUE(std::holds_alternative<Demonstration>(in_m1));
    if (GetParam() == Mode::M1) return std::get<Demonstration>(in_m1);
    auto other = demonstrate_in(GetParam(), executions, std::get<Demonstration>(in_m1));
    EXPECT_TRUE(std::holds_alternative<Demonstration>(other));
    return std::get<Demonstration>(other);
  }

  std::vector<std::string> closed_in(const Demonstration& demonstration) const {
    std::vector<std::string> closed;
    for (const DemonstrationStep& step : demonstration.steps) {
      if (step.action.type != ActionType::Close) continue;
      EXPECT_TRUE(step.tidying);
      EXPECT_FALSE(step.search);
      closed.push_back(step.action.args.front());
    }
    return closed;
  }

  /// What has the state after a demonstration.
  std::vector<std::string> left(Predicate state, const Demonstration& demonstration) const {
    World world = *World::create(start, knowledge, profile);
    for (const DemonstrationStep& step : demonstration.steps) EXPECT_TRUE(world.step(step.action).success);
    std::vector<std::string> ids;
    for (const Node& node : world.nodes())
      if (node.states.has(state)) ids.push_back(node.id);
    return ids;
  }
  std::vector<std::string> open_after(const Demonstration& demonstration) const {
    return left(Predicate::Open, demonstration);
  }
};

constexpr const char* kFromFridge =
    "(exists (?a - (Mug :where (exists (?f - Fridge) (inside ?a ?f)))) (exists (?b - SideTable) (at-end (on ?a ?b))))";

TEST_P(Tidying, WhatWasOpenedIsClosedAgain) {
  const Demonstration demonstration = shown(kFromFridge);
  EXPECT_THAT(open_after(demonstration), IsEmpty());
  EXPECT_THAT(closed_in(demonstration), ::testing::Contains("fridge_1"));
  EXPECT_THAT(needless_steps(wanted, start, demonstration, knowledge, profile), IsEmpty());
}

TEST_P(Tidying, TheGoalNeedsNoneOfItsSteps) {
  const Demonstration demonstration = shown(kFromFridge);
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  Rollout rollout(executions, rules_of(Mode::M1));
  rollout.go_on(actions_for_the_goal(demonstration));
  EXPECT_TRUE(rollout.reaches_goal());
  EXPECT_LT(actions_for_the_goal(demonstration).size(), demonstration.steps.size());
  EXPECT_LE(demonstration.shortest.size(), actions_for_the_goal(demonstration).size());
}

TEST_P(Tidying, WhatTheGoalWantsOpenStaysOpen) {
  const Demonstration demonstration = shown(
      "(exists (?f - Fridge) (exists (?a - (Mug :where (exists (?g - Fridge) (inside ?a ?g)))) (exists (?b - SideTable)"
      " (at-end (and (open ?f) (on ?a ?b))))))");
  EXPECT_THAT(open_after(demonstration), ::testing::Contains("fridge_1"));
  EXPECT_THAT(closed_in(demonstration), IsEmpty());
}

TEST_P(Tidying, WhatWasOpenAtTheStartStaysOpen) {
  set_state(start, "fridge_1", Predicate::Open);
  const Demonstration demonstration = shown(kFromFridge);
  EXPECT_THAT(closed_in(demonstration), IsEmpty());
}

TEST_P(Tidying, WhatWasTurnedOnIsTurnedOffAgain) {
  const Demonstration demonstration = shown("(exists (?x - Potato) (at-end (hot ?x)))");
  EXPECT_THAT(left(Predicate::PowerOn, demonstration), IsEmpty());
  EXPECT_THAT(open_after(demonstration), IsEmpty());
  const auto& steps = demonstration.steps;
  const auto off = std::find_if(steps.begin(), steps.end(),
                                [](const auto& step) { return step.action.type == ActionType::TurnOff; });
  EXPECT_EQ(off != steps.end(), GetParam() != Mode::M1) << "M1 has an action that does it all";
  if (off != steps.end()) {
    EXPECT_TRUE(off->tidying && !off->search);
  }
  EXPECT_THAT(needless_steps(wanted, start, demonstration, knowledge, profile), IsEmpty());
}

TEST_P(Tidying, WhatTheGoalWantsOnStaysOn) {
  const Demonstration demonstration =
      shown("(exists (?x - Potato) (exists (?m - Microwave) (at-end (and (hot ?x) (power_on ?m)))))");
  EXPECT_THAT(left(Predicate::PowerOn, demonstration), ::testing::ElementsAre("microwave_1"));
}

TEST_P(Tidying, IsLeftOutWhereNoStepsAreLeft) {
  const Demonstration demonstration = shown(kFromFridge);
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  const std::vector<Action> needed = actions_for_the_goal(demonstration);
  ModeRules rules = rules_of(GetParam());
  EXPECT_GT(tidied(executions, rules, needed).size(), needed.size());
  rules.limits.steps = static_cast<int>(needed.size());
  EXPECT_EQ(tidied(executions, rules, needed), needed);
}

TEST_P(Tidying, IsMarkedHoweverLongThePlan) {
  Demonstration demonstration = shown(kFromFridge);
  const Demonstration before = demonstration;
  DemonstrationStep turn;
  turn.action = {ActionType::TurnLeft, {}};
  demonstration.steps.insert(demonstration.steps.begin(), 60, turn);
  for (DemonstrationStep& step : demonstration.steps) step.tidying = step.search = false;
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  mark_tidying(executions, demonstration);
  const auto marks = [](const Demonstration& of) {
    std::vector<Action> marked;
    for (const DemonstrationStep& step : of.steps)
      if (step.tidying && step.action.type == ActionType::Close) marked.push_back(step.action);
    return marked;
  };
  EXPECT_THAT(marks(before), ::testing::Not(IsEmpty()));
  EXPECT_EQ(marks(demonstration), marks(before));
}

INSTANTIATE_TEST_SUITE_P(Modes, Tidying, ::testing::Values(Mode::M1, Mode::M2, Mode::M3),
                         [](const auto& param) { return std::string(name_of(param.param)); });

TEST(TidyingOfAPlan, WhereOneOfTwoHasToBeClosedOneIsTidying) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = house();
  const Formula wanted = goal(
      "(and (exists (?f - (either Fridge Dresser)) (at-end (closed ?f))) "
      "(exists (?f - Fridge) (sometime (open ?f))) "
      "(exists (?d - Dresser) (sometime (open ?d))))");
  auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
  std::vector<Action> plan;
  for (const char* id : {"fridge_1", "dresser_1"}) {
    plan.push_back({ActionType::GoTo, {id}});
    plan.push_back({ActionType::Open, {id}});
  }
  plan.push_back({ActionType::Close, {"dresser_1"}});
  plan.push_back({ActionType::GoTo, {"fridge_1"}});
  plan.push_back({ActionType::Close, {"fridge_1"}});
  plan.push_back({ActionType::Stop, {}});
  Demonstration demonstration = record(executions, Mode::M1, plan);
  ASSERT_EQ(demonstration.steps.size(), plan.size());
  mark_tidying(executions, demonstration);
  std::vector<std::string> tidying;
  for (const DemonstrationStep& step : demonstration.steps)
    if (step.tidying) tidying.push_back(to_text(step.action));
  EXPECT_THAT(tidying, ::testing::ElementsAre("close(dresser_1)"));
  Rollout rest(executions, rules_of(Mode::M1));
  rest.go_on(actions_for_the_goal(demonstration));
  EXPECT_TRUE(rest.reaches_goal());
}

TEST(TidyingOfAPlan, ComesAsSoonAsNothingIsNeededFromInside) {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene start = house();
  mug_in_fridge(start);
  start = at_rest(start);
  const Formula wanted = goal(kFromFridge);
  auto shown = demonstrate(wanted, start, knowledge, profile, {});
  ASSERT_TRUE(std::holds_alternative<Demonstration>(shown));
  const auto& steps = std::get<Demonstration>(shown).steps;
  const auto taken = std::find_if(steps.begin(), steps.end(),
                                  [](const DemonstrationStep& step) { return step.action.type == ActionType::PickUp; });
  ASSERT_NE(taken, steps.end());
  EXPECT_EQ((taken + 1)->action, (Action{ActionType::Close, {"fridge_1"}}));
}

}  // namespace
}  // namespace unietp::testing
