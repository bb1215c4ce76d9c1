// Composite actions show each moment that they lead through to the goal.
#include <gtest/gtest.h>

#include "expert/execution.h"
#include "expert/rollout.h"
#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

/// A potato is cooled in the fridge, which is shut before and after.
struct CooledInTheFridge : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = house();
  const std::vector<Action> plan{{ActionType::GoTo, {"potato_1"}},
                                 {ActionType::PickUp, {"potato_1"}},
                                 {ActionType::GoTo, {"fridge_1"}},
                                 {ActionType::CoolWith, {"fridge_1"}},
                                 {ActionType::Stop, {}}};

  bool reaches(const std::string& text) const {
    const Formula wanted = goal(text);
    auto executions = *ExecutionTree::of(wanted, start, knowledge, profile);
    Rollout rollout(executions, rules_of(Mode::M1));
    rollout.go_on(plan);
    EXPECT_EQ(rollout.done().size(), plan.size());
    return rollout.reaches_goal();
  }
  std::variant<Demonstration, Rejection> shown(const std::string& text) const {
    wanted_ = goal(text);
    return demonstrate(wanted_, start, knowledge, profile, {});
  }
  mutable Formula wanted_;
};

TEST_F(CooledInTheFridge, WhatMustStayShutIsSeenOpen) {
  EXPECT_TRUE(reaches("(exists (?p - Potato) (at-end (cool ?p)))"));
  EXPECT_TRUE(reaches("(exists (?f - Fridge) (at-end (closed ?f)))"));
  EXPECT_FALSE(reaches("(exists (?f - Fridge) (always (not (open ?f))))"));
  EXPECT_TRUE(reaches("(exists (?d - Dresser) (always (not (open ?d))))"));
}

TEST_F(CooledInTheFridge, WhatIsAskedForOnTheWayIsSeen) {
  EXPECT_TRUE(reaches("(exists (?f - Fridge) (sometime (open ?f)))"));
  EXPECT_TRUE(reaches("(exists (?f - Fridge) (exists (?p - Potato) (sometime (and (inside ?p ?f) (closed ?f)))))"));
  EXPECT_TRUE(reaches("(exists (?f - Fridge) (exists (?p - Potato) (before (open ?f) (cool ?p))))"));
  EXPECT_FALSE(reaches("(exists (?f - Fridge) (exists (?p - Potato) (before (cool ?p) (open ?f))))"));
  EXPECT_TRUE(reaches("(exists (?f - Fridge) (exists (?p - Potato) (until (not (cool ?p)) (inside ?p ?f))))"));
  EXPECT_FALSE(reaches("(exists (?f - Fridge) (exists (?p - Potato) (until (closed ?f) (inside ?p ?f))))"));
}

TEST_F(CooledInTheFridge, TheExpertKeepsToIt) {
  const auto cooled = shown("(exists (?p - Potato) (at-end (cool ?p)))");
  ASSERT_TRUE(std::holds_alternative<Demonstration>(cooled));
  const auto& steps = std::get<Demonstration>(cooled).steps;
  Scene scene = start;
  for (const DemonstrationStep& step : steps) {
    const bool is_composite = info(step.action.type).group == ActionClass::Composite;
    EXPECT_EQ(step.moments.size() > 1, is_composite) << to_text(step.action);
    Scene by_moment = scene;
    scene = apply(std::move(scene), step.changes);
    for (const Delta& moment : step.moments) by_moment = apply(std::move(by_moment), moment);
    EXPECT_TRUE(!is_composite || by_moment == scene);
  }
  EXPECT_EQ(replay(wanted_, start, std::get<Demonstration>(cooled), knowledge, profile), "");
  const auto kept_shut =
      shown("(and (exists (?p - Potato) (at-end (cool ?p))) (forall (?f - Fridge) (always (closed ?f))))");
  EXPECT_TRUE(std::holds_alternative<Rejection>(kept_shut));
}

}  // namespace
}  // namespace unietp::testing
