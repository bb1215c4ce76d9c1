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
constexpr const char* kPoured =
    "(exists (?a - Mug) (exists (?b - Bowl) (and (before (filled ?a water) (filled ?b water))"
    " (at-end (filled ?b water)))))";

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

TEST(WithoutConstraints, PouringIsNoOrderThatAnybodyCouldBreak) {
  EXPECT_EQ(without_constraints(goal(kPoured)), goal(kPoured));
  EXPECT_FALSE(constrains_the_way(goal(kPoured)));
  EXPECT_THAT(reversed(kPoured), IsEmpty());
}

TEST(ConstrainsTheWay, IsSaidOfOrdersAndWhatStays) {
  EXPECT_TRUE(constrains_the_way(goal(kOrdered)));
  EXPECT_TRUE(constrains_the_way(goal(kAllBefore)));
  EXPECT_TRUE(constrains_the_way(goal("(exists (?a - Mug) (and (at-end (held ?a)) (always (clean ?a))))")));
  EXPECT_FALSE(constrains_the_way(goal("(exists (?t - Table) (at-end (count = 2 (?a - Mug) (on ?a ?t))))")));
  EXPECT_FALSE(constrains_the_way(goal("(exists (?a - Mug) (not (always (clean ?a))))")));
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
