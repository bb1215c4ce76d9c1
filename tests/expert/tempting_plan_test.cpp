#include "expert/tempting_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;

struct TemptingPlan : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  Scene start = house();

  /// The demonstration of a goal, and what somebody would do who forgets its constraints.
  std::vector<Action> of(const std::string& text) {
    goal_ = goal(text);
    auto executions = ExecutionTree::of(goal_, start, knowledge, profile);
    EXPECT_TRUE(executions);
    auto shown = demonstrate(*executions, {});
    EXPECT_TRUE(std::holds_alternative<Demonstration>(shown)) << text;
    if (!std::holds_alternative<Demonstration>(shown)) return {};
    shown_ = std::get<Demonstration>(std::move(shown));
    return tempting_plan(*executions, shown_);
  }

  void expect_no_longer(const std::vector<Action>& plan) const {
    EXPECT_THAT(plan, Not(IsEmpty()));
    EXPECT_LE(plan.size(), shown_.steps.size());
  }

  bool reaches(const std::string& text, const std::vector<Action>& plan) const {
    const Formula judged = goal(text);
    auto executions = ExecutionTree::of(judged, start, knowledge, profile);
    World world = executions->world();
    std::vector<MomentId> moments{world.moment()};
    for (const Action& action : plan) {
      EXPECT_TRUE(executions->step(world, action).success) << to_text(action);
      moments.push_back(world.moment());
    }
    return executions->reaches_goal(std::move(moments));
  }

  Formula goal_;
  Demonstration shown_;
};

TEST_F(TemptingPlan, DoesWhatShouldComeSecondFirst) {
  const std::string ordered =
      "(exists (?x - Lamp) (exists (?y - Laptop) (and (before (power_on ?x) (power_on ?y))"
      " (at-end (and (power_on ?x) (power_on ?y))))))";
  const auto plan = of(ordered);
  expect_no_longer(plan);
  EXPECT_FALSE(reaches(ordered, plan));
  EXPECT_TRUE(reaches(
      "(exists (?x - Lamp) (exists (?y - Laptop) (and (before (power_on ?y) (power_on ?x)) (at-end (power_on ?x)))))",
      plan));
}

TEST_F(TemptingPlan, TakesWhatHasToStayIfThatIsNearer) {
  start.agent.position = {2.5, 1.9};  // at the table
  const std::string stays =
      "(exists (?t - SideTable) (exists (?a - Mug) (and (at-end (on ?a ?t))"
      " (forall (?m - (Mug :where (exists (?c - DiningTable) (on ?m ?c)))) (always (exists (?d - DiningTable) (on ?m "
      "?d)))))))";
  const auto plan = of(stays);
  expect_no_longer(plan);
  EXPECT_FALSE(reaches(stays, plan));
  EXPECT_TRUE(reaches("(exists (?t - SideTable) (exists (?a - Mug) (at-end (on ?a ?t))))", plan));
}

TEST_F(TemptingPlan, LeavesOutAnotherThanTheGoalDoes) {
  set_state(start, "mug_2", Predicate::Clean);
  const std::string but =
      "(exists (?t - SideTable) (and (forall (?a - (Mug :where (not (dirty ?a)))) (at-end (on ?a ?t)))"
      " (always (forall (?a - (Mug :where (dirty ?a))) (not (on ?a ?t))))))";
  const auto plan = of(but);
  expect_no_longer(plan);
  EXPECT_FALSE(reaches(but, plan));
  EXPECT_TRUE(
      reaches("(exists (?t - SideTable) (and (exists (?a - (Mug :where (dirty ?a))) (at-end (on ?a ?t)))"
              " (at-end (count = 2 (?b - Mug) (on ?b ?t)))))",
              plan));
}

TEST_F(TemptingPlan, IsNoneWhereOneMoreTakesLonger) {
  EXPECT_THAT(of("(exists (?t - SideTable) (at-end (count = 2 (?a - Mug) (on ?a ?t))))"), IsEmpty());
}

TEST_F(TemptingPlan, LeavesOneMoreThanExactlySoMany) {
  add(start, knowledge, "mug_4", "Mug", 2.4, 0.75, 0.751);
  add(start, knowledge, "mug_5", "Mug", 2.85, 0.72, 0.751);
  start = at_rest(start);
  const std::string on_it = "(exists (?t - DiningTable) (at-end (and (count = ";
  const std::string mugs = " (?a - Mug) (on ?a ?t)) (count = 0 (?b - Mug) (held ?b)))))";
  const auto plan = of(on_it + "2" + mugs);
  expect_no_longer(plan);
  EXPECT_TRUE(reaches(on_it + "3" + mugs, plan));
}

TEST_F(TemptingPlan, BringsSomeWithoutALookAtHowManyThereAreOfTheOtherKind) {
  move_to(start, "apple_1", 2.05, 3.7, 0.902);
  move_to(start, "mug_3", 0.35, 1.8, 0.701);
  start = at_rest(start);
  const std::string on_it = "(exists (?c - CounterTop) (at-end (and (count >= 1 (?a - Mug) (on ?a ?c)) (count ";
  const std::string kinds = " (number (?a - Mug) (on ?a ?c)) (number (?b - Apple) (on ?b ?c))))))";
  const auto plan = of(on_it + "=" + kinds);
  expect_no_longer(plan);
  EXPECT_TRUE(reaches(on_it + "<" + kinds, plan));
}

TEST_F(TemptingPlan, TakesAnyTwoInsteadOfTwoOfAKind) {
  start.agent.position = {2.2, 2.9};  // at the clean mug
  const std::string dirty = "(exists (?t - SideTable) (at-end (count = 2 (?a - (Mug :where (dirty ?a))) (on ?a ?t))))";
  const auto plan = of(dirty);
  expect_no_longer(plan);
  EXPECT_FALSE(reaches(dirty, plan));
  EXPECT_TRUE(reaches("(exists (?t - SideTable) (at-end (count = 2 (?a - Mug) (on ?a ?t))))", plan));
}

TEST_F(TemptingPlan, IsNoneWhereThereIsNoOneMore) {
  EXPECT_THAT(of("(exists (?t - SideTable) (at-end (count = 3 (?a - Mug) (on ?a ?t))))"), IsEmpty());
}

TEST_F(TemptingPlan, LeavesMoreThanAtMostSoMany) {
  const std::string few =
      "(exists (?t - DiningTable) (exists (?c - CounterTop) (at-end (and (count >= 2 (?a - Mug) (on ?a ?c))"
      " (count <= 0 (?a - Mug) (held ?a)) (count < 2 (?a - Mug) (on ?a ?t))))))";
  move_to(start, "mug_3", 2.55, 1.2, 0.751);
  start = at_rest(start);
  add(start, knowledge, "mug_4", "Mug", 2.2, 3.5, 0.902);
  start = at_rest(start);
  const auto plan = of(few);
  expect_no_longer(plan);
  EXPECT_FALSE(reaches(few, plan));
  EXPECT_TRUE(reaches("(exists (?c - CounterTop) (at-end (count >= 2 (?a - Mug) (on ?a ?c))))", plan));
}

TEST_F(TemptingPlan, IsNoneWhereNothingElseIsAsShort) {
  EXPECT_THAT(of("(exists (?f - Fridge) (exists (?a - Apple) (at-end (inside ?a ?f))))"), IsEmpty()) << "no constraint";
  EXPECT_THAT(of("(exists (?x - Lamp) (and (at-end (power_on ?x)) (forall (?f - Fridge) (always (closed ?f)))))"),
              IsEmpty())
      << "nobody opens the fridge for that";
}

}  // namespace
}  // namespace unietp::testing
