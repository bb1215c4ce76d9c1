#include "sense/grade_goal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sense/committed_sense.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

TaskSense graded(const std::string& goal, Simulator simulator = Simulator::Ai2thor) {
  const auto formula = parse_formula("goal", goal, FormulaUse::Goal);
  EXPECT_TRUE(formula) << (formula ? "" : format(formula.error()));
  return grade_goal(*formula, committed_knowledge(simulator), test::committed_sense(), test::committed_words());
}

TEST(GradeGoal, IsThatOfTheWorstPart) {
  EXPECT_EQ(graded("(exists (?a - Book) (exists (?b - Desk) (at-end (on ?a ?b))))").grade, Grade::Usual);
  const auto bad = graded(
      "(exists (?a - Book) (exists (?b - Desk) (exists (?c - Tomato) (exists (?d - Toilet) (at-end (and (on ?a ?b) "
      "(on ?c ?d)))))))");
  EXPECT_EQ(bad.grade, Grade::Senseless);
  EXPECT_THAT(bad.parts.front().part, HasSubstr("tomato on toilet"));
}

TEST(GradeGoal, WhatIsOnAPlateGoesWhereThePlateGoes) {
  const auto goal = [](const std::string& thing, const std::string& place) {
    return "(exists (?a - " + thing + ") (exists (?b - plate) (exists (?c - " + place +
           ") (at-end (and (on ?a ?b) (inside ?b ?c))))))";
  };
  const auto bad = graded(goal("apple", "dishwasher"), Simulator::Habitat);
  EXPECT_EQ(bad.grade, Grade::Senseless);
  EXPECT_THAT(bad.parts.front().part, HasSubstr("apple in dishwasher"));
  EXPECT_NE(graded(goal("apple", "fridge"), Simulator::Habitat).grade, Grade::Senseless);
}

TEST(GradeGoal, AFloorIsThatOfARoom) {
  const auto goal = [](const std::string& room) {
    return "(exists (?a - toilet_brush) (exists (?r - " + room + ") (at-end (on_floor ?a ?r))))";
  };
  EXPECT_EQ(graded(goal("bathroom"), Simulator::Habitat).grade, Grade::Usual);
  const auto elsewhere = graded(goal("bedroom"), Simulator::Habitat);
  EXPECT_NE(elsewhere.grade, Grade::Usual);
  EXPECT_THAT(elsewhere.parts.front().part, HasSubstr("toilet brush in the bedroom"));
}

TEST(GradeGoal, JudgesWhatFollowsWhat) {
  EXPECT_EQ(graded("(exists (?a - Potato) (exists (?b - Plate) (at-end (and (cooked ?a) (on ?a ?b)))))").grade,
            Grade::Usual);
  EXPECT_EQ(graded("(exists (?a - Potato) (at-end (and (cooked ?a) (held ?a))))").grade, Grade::Senseless);
  EXPECT_EQ(graded("(exists (?a - Mug) (exists (?b - GarbageCan) (at-end (and (inside ?a ?b) (clean ?a)))))").grade,
            Grade::Senseless);
}

TEST(PiecesOf, AreEachPartAndEachPairThatGoesTogetherOnce) {
  const auto goal = parse_formula(
      "goal", "(exists (?a - Potato) (exists (?b - Plate) (at-end (and (cooked ?a) (on ?a ?b)))))", FormulaUse::Goal);
  ASSERT_TRUE(goal);
  const auto pieces = pieces_of(wants_of(*goal));
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].wants.size(), 1U);
  EXPECT_EQ(pieces[1].wants.size(), 1U);
  ASSERT_EQ(pieces[2].wants.size(), 2U);
  EXPECT_NE(pieces[2].wants[0].predicate, pieces[2].wants[1].predicate);
}

TEST(GradeGoal, JudgesWhatIsBroughtTogether) {
  const auto danger = graded(
      "(exists (?c - CounterTop) (exists (?a - Bread) (exists (?b - SprayBottle) (at-end (and (on ?a ?c) (on ?b "
      "?c))))))");
  EXPECT_EQ(danger.grade, Grade::Senseless);
  EXPECT_THAT(danger.parts.front().sense.reasons.front(), HasSubstr("rule cleaner-by-food"));
  EXPECT_EQ(graded("(exists (?a - Knife) (exists (?b - TeddyBear) (at-end (next_to ?a ?b))))").grade, Grade::Senseless);
}

TEST(GradeGoal, NobodyUsesWhatWasThrownAway) {
  EXPECT_EQ(
      graded("(exists (?a - (Tomato :where (exists (?b - GarbageCan) (inside ?a ?b)))) (at-end (sliced ?a)))").grade,
      Grade::Senseless);
}

TEST(GradeGoal, ThingsAreToldByWhatIsUsualInTheSameRoom) {
  const auto goal = [](const std::string& relation, const std::string& landmark) {
    return "(exists (?a - (clothes :where (exists (?p - " + landmark + ") (" + relation +
           " ?a ?p)))) (exists (?b - wardrobe) (at-end (inside ?a ?b))))";
  };
  for (const auto* relation : {"nearest", "next_to"}) {
    EXPECT_EQ(graded(goal(relation, "bed"), Simulator::Habitat).grade, Grade::Usual) << relation;
    const auto odd = graded(goal(relation, "oven"), Simulator::Habitat);
    EXPECT_EQ(odd.grade, Grade::Tolerable) << relation;
    EXPECT_EQ(odd.parts.front().sense.why, "apart");
  }
}

TEST(GradeGoal, NothingIsToldByBeingShutUpWhereItMakesNoSense) {
  const auto goal = [](const std::string& place) {
    return "(exists (?a - (meat_loaf :where (exists (?p - " + place + ") (inside ?a ?p)))) (at-end (hot ?a)))";
  };
  EXPECT_EQ(graded(goal("fridge"), Simulator::Behavior).grade, Grade::Usual);
  EXPECT_EQ(graded(goal("bottom_cabinet"), Simulator::Behavior).grade, Grade::Tolerable);
}

TEST(GradeGoal, TwoThingsHaveNamesOfWhichNoneMayMeanTheOther) {
  const auto goal = [](const std::string& one, const std::string& other) {
    return "(exists (?a - " + one + ") (exists (?b - " + other +
           ") (exists (?c - fridge) (at-end (and (inside ?a ?c) (inside ?b ?c))))))";
  };
  const auto unclear = graded(goal("fruit", "apple"), Simulator::Habitat);
  EXPECT_EQ(unclear.grade, Grade::Tolerable);
  EXPECT_EQ(unclear.parts.front().sense.why, "one_name");
  EXPECT_EQ(graded(goal("egg", "apple"), Simulator::Habitat).grade, Grade::Usual);
}

TEST(GradeGoal, NobodyUsesWhatIsDirtyOrPutsItAway) {
  const auto goal = [](const std::string& what) { return "(exists (?a - (Mug :where (dirty ?a))) " + what + ")"; };
  EXPECT_EQ(graded(goal("(at-end (clean ?a))")).grade, Grade::Usual);
  EXPECT_EQ(graded(goal("(exists (?b - Sink) (at-end (inside ?a ?b)))")).grade, Grade::Usual);
  for (const auto* what : {"(at-end (filled ?a coffee))", "(exists (?b - Cabinet) (at-end (inside ?a ?b)))"}) {
    const auto used = graded(goal(what));
    EXPECT_EQ(used.grade, Grade::Tolerable) << what;
    EXPECT_EQ(used.parts.front().sense.why, "dirty");
  }
  const auto onto = [](const std::string& plate) {
    return "(exists (?a - Potato) (exists (?b - " + plate + ") (at-end (on ?a ?b))))";
  };
  EXPECT_EQ(graded(onto("Plate")).grade, Grade::Usual);
  EXPECT_EQ(graded(onto("(Plate :where (dirty ?b))")).grade, Grade::Tolerable);
}

TEST(GradeGoal, WhatGoesToAPlaceComesIntoItsRoom) {
  const auto goal = [](const std::string& room) {
    return "(exists (?a - Potato) (exists (?b - (Sink :where (exists (?r - " + room +
           ") (in_room ?b ?r)))) (at-end (inside ?a ?b))))";
  };
  EXPECT_NE(graded(goal("kitchen")).grade, Grade::Senseless);
  const auto odd = graded(goal("bathroom"));
  EXPECT_EQ(odd.grade, Grade::Senseless);
  EXPECT_THAT(odd.parts.front().part, HasSubstr("potato in the bathroom"));
}

TEST(GradeGoal, ACabinetInAKitchenIsAKitchenCabinet) {
  const auto goal = [](const std::string& room) {
    return "(exists (?a - Towel) (exists (?b - (Cabinet :where (exists (?r - " + room +
           ") (in_room ?b ?r)))) (at-end (on ?a ?b))))";
  };
  EXPECT_EQ(graded(goal("bathroom")).grade, Grade::Usual);
  const auto odd = graded(goal("kitchen"));
  EXPECT_EQ(odd.grade, Grade::Senseless);
  EXPECT_THAT(odd.parts.front().part, HasSubstr("towel on cabinet in the kitchen"));
}

TEST(GradeGoal, NobodyAsksForASingleOneOfWhatComesInNumbers) {
  const auto goal = [](const std::string& variable) {
    return "(exists (?b - fridge) (" + variable + " (at-end (inside ?a ?b))))";
  };
  const auto one = graded(goal("exists (?a - radish)"), Simulator::Behavior);
  EXPECT_EQ(one.grade, Grade::Senseless);
  EXPECT_EQ(one.parts.front().part, "a single radish");
  EXPECT_EQ(one.parts.front().sense.why, "rule:single-piece");
  EXPECT_NE(graded(goal("forall (?a - radish)"), Simulator::Behavior).grade, Grade::Senseless);
  EXPECT_NE(graded(goal("exists (?a - (either radish apple))"), Simulator::Behavior).grade, Grade::Senseless)
      << "another thing will do";
  const std::string several = "(exists (?b - fridge) (at-end (count >= 2 (?a - radish) (inside ?a ?b))))";
  EXPECT_NE(graded(several, Simulator::Behavior).grade, Grade::Senseless);
}

TEST(GradeGoal, NobodyWashesWhatIsToldByBeingClean) {
  const auto goal = [](const std::string& place) {
    return "(exists (?a - (Mug :where (clean ?a))) (exists (?b - " + place + ") (at-end (inside ?a ?b))))";
  };
  EXPECT_EQ(graded(goal("Cabinet")).grade, Grade::Usual);
  EXPECT_EQ(graded(goal("Sink")).grade, Grade::Tolerable);
}

TEST(GradeGoal, SlicesAreGradedAsSlices) {
  EXPECT_EQ(graded("(exists (?s - Lettuce/slice) (at-end (hot ?s)))").grade, Grade::Senseless);
  EXPECT_EQ(graded("(exists (?s - Bread/slice) (at-end (hot ?s)))").grade, Grade::Usual);
}

TEST(GradeGoal, OfAlternativesTheWorstCounts) {
  EXPECT_EQ(graded("(exists (?a - (either Apple Laptop)) (exists (?b - Fridge) (at-end (inside ?a ?b))))").grade,
            Grade::Senseless);
}

TEST(GradeGoal, WhatHasNothingToDoWithOneAnotherIsTolerableAtBest) {
  EXPECT_EQ(graded("(exists (?a - Safe) (exists (?b - Mug) (exists (?c - DiningTable) (at-end (and (open ?a) (on ?b "
                   "?c))))))")
                .grade,
            Grade::Tolerable);
}

TEST(GradeGoal, WipingAndSpreadingKnowTheSubstance) {
  EXPECT_EQ(graded("(exists (?a - countertop) (at-end (covered ?a acetone)))", Simulator::Behavior).grade,
            Grade::Senseless);
  EXPECT_EQ(graded("(exists (?a - shelf) (at-end (not (covered ?a dust))))", Simulator::Behavior).grade, Grade::Usual);
}

TEST(GradeGoal, GoingSomewhereNeedsNoReason) {
  EXPECT_EQ(graded("(exists (?r - kitchen) (at-end (in_room agent ?r)))").grade, Grade::Usual);
}

}  // namespace
}  // namespace unietp
