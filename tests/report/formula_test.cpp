#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/formula_census.h"
#include "report/goal_prose.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;

Formula goal(const std::string& text) {
  auto read = parse_formula("goal", text, FormulaUse::Goal);
  EXPECT_TRUE(read) << (read ? "" : format(read.error()));
  return read ? *read : Formula();
}

TEST(FormulaCensus, ANameCountsOnceAndWhatAWhereSaysCountsToo) {
  const auto census = census_of(
      goal("(and (at-end (exists (?a - (Mug :where (dirty ?a))) (clean ?a))) (always (forall (?b - Fridge) (not (open "
           "?b)))))"));
  EXPECT_THAT(census.operators, ElementsAre("always", "and", "at-end", "exists", "forall", "not", "where"));
  EXPECT_THAT(census.predicates, ElementsAre("clean", "dirty", "open"));
}

TEST(GoalProse, QuantifiersOfAKindShareALine) {
  EXPECT_THAT(
      goal_prose(goal("(exists (?a - HandTowel) (exists (?b - Sofa) (at-end (on ?a ?b))))")),
      ElementsAre(ProseLine{0, "for some hand towel a and some sofa b:"}, ProseLine{1, "at the end, a is on b"}));
}

TEST(GoalProse, SaysWhatIsMeantOrderAndNumbers) {
  EXPECT_THAT(
      goal_prose(goal("(forall (?m - (Mug :where (dirty ?m))) (before (clean ?m) (exists (?c - Cabinet) (inside "
                      "?m ?c))))")),
      ElementsAre(ProseLine{0, "for every mug m (such that, at the start, m is dirty):"}, ProseLine{1, "first"},
                  ProseLine{2, "m is clean"}, ProseLine{1, "and later, for the first time,"},
                  ProseLine{2, "for some cabinet c:"}, ProseLine{3, "m is in c"}));
  EXPECT_THAT(goal_prose(goal("(at-end (count >= 2 (?a - Mug) (and (filled ?a water) (not (held ?a)))))")),
              ElementsAre(ProseLine{0, "at the end:"}, ProseLine{1, "for at least 2 mug a:"},
                          ProseLine{2, "a is filled with water"}, ProseLine{2, "a is not held"}));
}

TEST(WordsOfCategory, AreThoseOfItsName) {
  EXPECT_EQ(words_of_category("HandTowel"), "hand towel");
  EXPECT_EQ(words_of_category("coffee_table.n.01"), "coffee table");
  EXPECT_EQ(words_of_category("TVStand"), "tvstand");
}

}  // namespace
}  // namespace unietp
