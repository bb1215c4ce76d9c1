#include "expert/goal_reading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/expert/house.h"

namespace unietp::testing {
namespace {

using ::testing::HasSubstr;

struct Reading : ::testing::Test {
  const Knowledge knowledge = house_knowledge();
  const Profile profile = house_profile();
  const Scene start = house();

  std::vector<std::string> ways(const std::string& text, const CostPenalties& experience = {}) const {
    const Formula formula = goal(text);
    const auto executions = ExecutionTree::of(formula, start, knowledge, profile);
    const Situation situation = look_around(*executions, Mode::M1);
    std::vector<std::string> texts;
    for (const Alternative& way : read_goal(formula, situation, experience)) texts.push_back(to_text(way, situation));
    return texts;
  }
};

TEST_F(Reading, ListsEachWitnessOnce) {
  EXPECT_THAT(ways("(exists (?x - Mug) (at-end (held ?x)))"),
              ::testing::UnorderedElementsAre("held(mug_1); ", "held(mug_2); ", "held(mug_3); "));
}

TEST_F(Reading, ReadsAReferringDomainInTheStart) {
  EXPECT_THAT(ways("(exists (?x - (Mug :where (not (dirty ?x)))) (at-end (held ?x)))"),
              ::testing::ElementsAre("held(mug_3); "));
}

TEST_F(Reading, KeepsOneObjectForOneVariable) {
  for (const std::string& way : ways("(exists (?x - Mug) (at-end (and (clean ?x) (held ?x))))")) {
    const auto of = [&](const char* id) { return way.find(id) != std::string::npos; };
    EXPECT_EQ(of("mug_1") + of("mug_2") + of("mug_3"), 1) << way;
  }
}

TEST_F(Reading, LeavesOutWhatContradictsItself) {
  EXPECT_THAT(ways("(exists (?x - Mug) (at-end (and (clean ?x) (dirty ?x))))"), ::testing::IsEmpty());
  EXPECT_THAT(ways("(exists (?x - Mug) (exists (?y - Mug) (at-end (and (not (= ?x ?y)) (held ?x) (held ?y)))))"),
              ::testing::IsEmpty());
  EXPECT_THAT(ways("(exists (?x - Mug) (at-end (and (on ?x ?x))))"), ::testing::IsEmpty());
}

TEST_F(Reading, AnExactNumberSaysOfEveryMemberWhetherItCounts) {
  for (const std::string& way : ways("(exists (?b - SideTable) (at-end (count = 1 (?x - Mug) (on ?x ?b))))")) {
    for (const char* mug : {"mug_1", "mug_2", "mug_3"}) EXPECT_THAT(way, HasSubstr(mug));
  }
}

TEST_F(Reading, LeavesOutWhatUndoesATruthOfTheStart) {
  EXPECT_THAT(ways("(exists (?b - SideTable) (exists (?x - Mug) (at-end (and (on ?x ?b) (forall (?y - Mug) (not (on "
                   "?y ?b)))))))"),
              ::testing::IsEmpty());
}

TEST_F(Reading, WaysToMeetTheRestShareWhatStandsAlready) {
  const Formula formula =
      goal("(exists (?x - Mug) (at-end (and (held ?x) (forall (?y - Plate) (forall (?z - Plate) (not (on ?y ?z)))))))");
  const auto executions = ExecutionTree::of(formula, start, knowledge, profile);
  const Situation situation = look_around(*executions, Mode::M1);
  const auto list = read_goal(formula, situation, {});
  ASSERT_GT(list.size(), 1U);
  ASSERT_NE(list.front().standing, nullptr);
  for (const Alternative& way : list) {
    EXPECT_EQ(way.standing, list.front().standing);
    EXPECT_THAT(to_text(way, situation), HasSubstr("not on(plate_1, plate_1)"));
  }
}

TEST_F(Reading, PutsBeforeIntoAnOrderOfMoments) {
  EXPECT_THAT(ways("(exists (?x - Plate) (exists (?y - Mug) (and (before (held ?x) (held ?y)) (at-end (held ?y)))))"),
              ::testing::Contains("held(plate_1); then held(mug_1); then held(mug_1); "));
}

TEST_F(Reading, ImaginesSlicesOfWhatCanBeCut) {
  EXPECT_THAT(
      ways("(exists (?s - Apple/slice) (at-end (held ?s)))"),
      ::testing::UnorderedElementsAre("held(apple_1/slice_1); ", "held(apple_1/slice_2); ", "held(apple_1/slice_3); ",
                                      "held(apple_2/slice_1); ", "held(apple_2/slice_2); ", "held(apple_2/slice_3); "));
}

TEST_F(Reading, WhatFailedComesLast) {
  const Formula formula = goal("(exists (?x - Mug) (at-end (held ?x)))");
  const auto executions = ExecutionTree::of(formula, start, knowledge, profile);
  const Situation situation = look_around(*executions, Mode::M1);
  const Literal first = read_goal(formula, situation, {}).front().end.front();
  CostPenalties experience;
  experience.literals.emplace_back(first, 100);
  EXPECT_EQ(read_goal(formula, situation, experience).back().end.front(), first);
}

}  // namespace
}  // namespace unietp::testing
