#include "logic/formula_size.h"

#include <gtest/gtest.h>

#include "core/limits.h"

namespace unietp {
namespace {

Formula goal_from(const std::string& text) {
  const auto goal = parse_formula("goal", text, FormulaUse::Goal);
  EXPECT_TRUE(goal) << format(goal.error());
  return goal ? *goal : Formula();
}

/// `count` quantifiers in one another around the body.
std::string quantified(int count) {
  std::string text = "(open ?v0)";
  for (int i = 0; i < count; ++i) text = "(forall (?v" + std::to_string(i) + " - object) " + text + ")";
  return "(at-end " + text + ")";
}

TEST(FormulaSize, OneMoreThanEachBoundIsRefused) {
  EXPECT_TRUE(parse_formula("goal", quantified(limits::kQuantifiers), FormulaUse::Goal));
  const auto deep = parse_formula("goal", quantified(limits::kQuantifiers + 1), FormulaUse::Goal);
  ASSERT_FALSE(deep);
  EXPECT_EQ(deep.error().message, "the formula has 9 quantifiers in one another; accepted are at most 8");
  std::string temporal = "(exists (?m - Mug) (open ?m))";
  for (int i = 0; i < limits::kTemporal; ++i) temporal = "(sometime " + temporal + ")";
  EXPECT_TRUE(parse_formula("goal", temporal, FormulaUse::Goal));
  EXPECT_FALSE(parse_formula("goal", "(sometime " + temporal + ")", FormulaUse::Goal));
  std::string wide = "(at-end (exists (?m - Mug) (and";
  for (int i = 0; i < limits::kFormulaParts / 2; ++i) wide += " (open ?m)";
  EXPECT_FALSE(parse_formula("goal", wide + ")))", FormulaUse::Goal));
}

TEST(FormulaSize, CombinationsAreThoseOfTheQuantifiersInOneAnother) {
  const auto ten = [](const Domain&) { return 10.0; };
  EXPECT_GE(combinations_of(goal_from(quantified(6)), ten), 1e6);
  EXPECT_LT(combinations_of(goal_from(quantified(2)), ten), 1e3);
  const auto beside = goal_from(
      "(at-end (and (exists (?m - Mug) (open ?m)) (exists (?m - Mug) (open ?m)) (exists (?m - Mug) (open ?m))))");
  EXPECT_LT(combinations_of(beside, ten), 100);
  EXPECT_GE(combinations_of(goal_from("(at-end (exists (?m - (Mug :where (exists (?f - Fridge) (inside ?m ?f)))) "
                                      "(open ?m)))"),
                            ten),
            100);
}

}  // namespace
}  // namespace unietp
