#include "logic/constraints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Formula goal(const std::string& text) {
  const auto formula = parse_formula("test", text, FormulaUse::Goal);
  EXPECT_TRUE(formula) << (formula ? "" : format(formula.error()));
  return formula ? *formula : Formula{};
}

std::vector<std::string> reversed(const std::string& text) {
  std::vector<std::string> texts;
  for (const Formula& one : with_an_order_reversed(goal(text))) texts.push_back(to_text(one));
  return texts;
}

constexpr const char* kOrdered =
    "(exists (?a - Mug) (exists (?b - Table) (and (before (clean ?a) (on ?a ?b)) (at-end (on ?a ?b)))))";
constexpr const char* kAllBefore =
    "(exists (?t - Table) (and (until (count = 0 (?b - Mug) (on ?b ?t)) (forall (?a - Plate) (on ?a ?t)))"
    " (at-end (forall (?b - Mug) (on ?b ?t)))))";
constexpr const char* kSliced =
    "(exists (?a - Apple) (exists (?s - Apple/slice) (and (before (sliced ?a) (cooked ?s))"
    " (at-end (and (slice_of ?s ?a) (cooked ?s))))))";

TEST(WithoutConstraints, NothingHasToStayOrComeFirst) {
  EXPECT_EQ(without_constraints(goal(kOrdered)),
            goal("(exists (?a - Mug) (exists (?b - Table) (and (and (sometime (clean ?a)) (sometime (on ?a ?b)))"
                 " (at-end (on ?a ?b)))))"));
  EXPECT_EQ(without_constraints(goal("(exists (?a - Mug) (and (at-end (held ?a)) (always (clean ?a))))")),
            goal("(exists (?a - Mug) (and (at-end (held ?a)) (and)))"));
}

TEST(WithoutConstraints, MoreThanExactlySoManyWouldDo) {
  EXPECT_EQ(without_constraints(goal("(exists (?t - Table) (at-end (count = 2 (?a - Mug) (on ?a ?t))))")),
            goal("(exists (?t - Table) (at-end (count >= 2 (?a - Mug) (on ?a ?t))))"));
  const Formula none = goal("(exists (?t - Table) (at-end (count = 0 (?a - Mug) (on ?a ?t))))");
  EXPECT_EQ(without_constraints(none), none);
}

constexpr const char* kExactly = "(exists (?t - Table) (at-end (count = 2 (?a - Mug) (on ?a ?t))))";
constexpr const char* kAtMost =
    "(exists (?t - Table) (exists (?b - Bed) (at-end (and (count >= 2 (?a - Mug) (on ?a ?b))"
    " (count <= 1 (?a - Mug) (on ?a ?t))))))";

TEST(WithoutConstraints, MoreThanAtMostSoManyWouldDo) {
  EXPECT_EQ(without_constraints(goal(kAtMost)),
            goal("(exists (?t - Table) (exists (?b - Bed) (at-end (and (count >= 2 (?a - Mug) (on ?a ?b)) (and)))))"));
  const Formula fewer = goal("(exists (?t - Table) (at-end (count < 2 (?a - Mug) (on ?a ?t))))");
  EXPECT_EQ(without_constraints(fewer), goal("(exists (?t - Table) (at-end (and)))"));
}

constexpr const char* kAsMany =
    "(exists (?t - Table) (at-end (and (count >= 2 (?a - Mug) (on ?a ?t))"
    " (count = (number (?a - Mug) (on ?a ?t)) (number (?b - Cup) (on ?b ?t))))))";

TEST(WithoutConstraints, AnyNumberWouldDoOfAsManyAs) {
  EXPECT_EQ(without_constraints(goal(kAsMany)),
            goal("(exists (?t - Table) (at-end (and (count >= 2 (?a - Mug) (on ?a ?t)) (and))))"));
  const Formula more =
      goal("(exists (?t - Table) (at-end (count > (number (?a - Mug) (on ?a ?t)) (number (?b - Cup) (on ?b ?t)))))");
  EXPECT_EQ(without_constraints(more), more) << "what is asked for is no constraint";
}

TEST(WithOneTooMany, OneMoreThanExactlySoMany) {
  const auto more = with_one_too_many(goal(kExactly));
  ASSERT_EQ(more.size(), 1U);
  EXPECT_EQ(to_text(more.front()), "(exists (?t - Table) (at-end (count = 3 (?a - Mug) (on ?a ?t))))");
  const auto left = with_one_too_many(goal(kAtMost));
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(to_text(left.front()),
            "(exists (?t - Table) (exists (?b - Bed) (at-end (and (count >= 2 (?a - Mug) (on ?a ?b))"
            " (count >= 2 (?a - Mug) (on ?a ?t))))))");
  const auto fewer = with_one_too_many(goal("(exists (?t - Table) (at-end (count < 2 (?a - Mug) (on ?a ?t))))"));
  ASSERT_EQ(fewer.size(), 1U);
  EXPECT_EQ(to_text(fewer.front()), "(exists (?t - Table) (at-end (count >= 2 (?a - Mug) (on ?a ?t))))");
}

TEST(WithOneTooMany, MoreAndFewerThanOfTheOtherKind) {
  const auto unequal = with_one_too_many(goal(kAsMany));
  ASSERT_EQ(unequal.size(), 2U);
  const std::string before = "(exists (?t - Table) (at-end (and (count >= 2 (?a - Mug) (on ?a ?t)) (count ";
  const std::string after = " (number (?a - Mug) (on ?a ?t)) (number (?b - Cup) (on ?b ?t))))))";
  EXPECT_EQ(to_text(unequal[0]), before + ">" + after);
  EXPECT_EQ(to_text(unequal[1]), before + "<" + after);
}

TEST(HastyReadings, OfCountsOfWhatAPhraseTellsFromOthersForgetThePhrase) {
  const auto readings =
      hasty_readings(goal("(exists (?t - Table) (at-end (count = 2 (?a - (Mug :where (dirty ?a))) (on ?a ?t))))"));
  ASSERT_EQ(readings.size(), 3U);
  EXPECT_EQ(to_text(readings[1].goal),
            "(exists (?t - Table) (at-end (count = 3 (?a - (Mug :where (dirty ?a))) (on ?a ?t))))");
  EXPECT_EQ(to_text(readings[2].goal), "(exists (?t - Table) (at-end (count >= 2 (?a - Mug) (on ?a ?t))))");
  EXPECT_FALSE(readings[2].takes_more) << "any two are as many as two dirty ones";
}

TEST(HastyReadings, OfAllButSomeLeaveOutAnother) {
  const auto readings = hasty_readings(
      goal("(exists (?t - Table) (and (and (forall (?a - (Mug :where (not (dirty ?a)))) (at-end (on ?a ?t)))"
           " (always (forall (?a - (Mug :where (dirty ?a))) (not (on ?a ?t))))) (at-end (clean ?t))))"));
  ASSERT_EQ(readings.size(), 3U);
  EXPECT_EQ(to_text(readings[1].goal),
            "(exists (?t - Table) (and (and (at-end (count >= (number (?a - Mug) (on ?a ?t))"
            " (number (?a - (Mug :where (not (dirty ?a)))) (and))))"
            " (exists (?a - (Mug :where (dirty ?a))) (at-end (on ?a ?t)))) (at-end (clean ?t))))");
  const auto others =
      hasty_readings(goal("(exists (?t - Table) (and (forall (?a - (Mug :where (not (dirty ?a)))) (at-end (on ?a ?t)))"
                          " (always (forall (?b - (Cup :where (dirty ?b))) (not (on ?b ?t))))))"));
  EXPECT_EQ(others.size(), 2U) << "what stays is of another kind";
}

TEST(HastyReadings, AreOfOrdersOfWhatStaysAndOfCounts) {
  EXPECT_EQ(hasty_readings(goal(kOrdered)).size(), 1U);
  EXPECT_EQ(hasty_readings(goal(kAllBefore)).size(), 1U);
  EXPECT_EQ(hasty_readings(goal(kAtMost)).size(), 2U);
  EXPECT_EQ(hasty_readings(goal(kAsMany)).size(), 3U);
  const auto exactly = hasty_readings(goal(kExactly));
  ASSERT_EQ(exactly.size(), 2U);
  EXPECT_FALSE(exactly[0].takes_more);
  EXPECT_TRUE(exactly[1].takes_more);
  const auto stays =
      hasty_readings(goal("(exists (?a - (Mug :where (dirty ?a))) (and (at-end (held ?a)) (always (clean ?a))))"));
  ASSERT_EQ(stays.size(), 2U);
  EXPECT_EQ(stays[1].goal, without_references(stays[0].goal));
  EXPECT_THAT(hasty_readings(goal("(exists (?a - Mug) (not (always (clean ?a))))")), IsEmpty());
  EXPECT_THAT(hasty_readings(goal("(exists (?a - Mug) (at-end (held ?a)))")), IsEmpty());
}

TEST(WithAnOrderReversed, TheSecondPartComesFirst) {
  EXPECT_THAT(reversed(kOrdered),
              ElementsAre("(exists (?a - Mug) (exists (?b - Table) (and (before (on ?a ?b) (clean ?a))"
                          " (at-end (on ?a ?b)))))"));
  EXPECT_THAT(reversed(kAllBefore),
              ElementsAre("(exists (?t - Table) (and (before (count >= 1 (?b - Mug) (on ?b ?t))"
                          " (forall (?a - Plate) (on ?a ?t))) (at-end (forall (?b - Mug) (on ?b ?t)))))"));
}

TEST(WithAnOrderReversed, WhatIsNotCutYetIsDoneToTheWhole) {
  EXPECT_THAT(reversed(kSliced), ElementsAre("(exists (?a - Apple) (exists (?s - Apple/slice) (and (before (cooked ?a)"
                                             " (sliced ?a)) (at-end (and (slice_of ?s ?a) (cooked ?s))))))"));
}

TEST(WithAnOrderReversed, OfSeveralOrdersOneEach) {
  EXPECT_EQ(reversed("(exists (?a - Mug) (and (before (clean ?a) (hot ?a)) (before (hot ?a) (held ?a))))").size(), 2U);
  EXPECT_THAT(reversed("(exists (?a - Mug) (at-end (held ?a)))"), IsEmpty());
}

TEST(WithoutReferences, ObjectsAreNamedByCategoryAlone) {
  EXPECT_EQ(without_references(goal("(exists (?a - (Mug :where (dirty ?a))) (at-end (held ?a)))")),
            goal("(exists (?a - Mug) (at-end (held ?a)))"));
}

}  // namespace
}  // namespace unietp
