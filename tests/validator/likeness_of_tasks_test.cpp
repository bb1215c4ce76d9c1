#include "validator/likeness_of_tasks.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "core/text.h"

namespace unietp {
namespace {

GoalPrint print_of(const std::string& text) {
  const auto formula = parse_formula("goal", text, FormulaUse::Goal);
  EXPECT_TRUE(formula) << format(formula.error());
  return print_of_goal(formula ? *formula : Formula());
}

double goals(const std::string& a, const std::string& b) { return likeness_of_goals(print_of(a), print_of(b)); }
double texts(const std::string& a, const std::string& b) {
  return likeness_of_texts(print_of_text(a), print_of_text(b), -1);
}

constexpr const char* kCleanThenPlaced =
    "(exists (?b - Sofa) (exists (?a - Mug) (and (before (clean ?a) (on ?a ?b)) (at-end (on ?a ?b)))))";

TEST(LikenessOfGoals, IsOneForOtherNamesAndOrders) {
  EXPECT_EQ(goals(kCleanThenPlaced,
                  "(exists (?x - Mug) (exists (?y - Sofa) (and (at-end (on ?x ?y)) (before (clean ?x) (on ?x ?y)))))"),
            1);
}

TEST(LikenessOfGoals, IsLessForWhatMeansAnotherThing) {
  for (const char* other :
       {"(exists (?b - Sofa) (exists (?a - Mug) (and (before (on ?a ?b) (clean ?a)) (at-end (on ?a ?b)))))",
        "(exists (?b - Sofa) (exists (?a - Mug) (and (before (dirty ?a) (on ?a ?b)) (at-end (on ?a ?b)))))",
        "(exists (?b - Sofa) (exists (?a - Mug) (and (before (clean ?b) (on ?a ?b)) (at-end (on ?a ?b)))))",
        "(exists (?b - Sofa) (forall (?a - Mug) (and (before (clean ?a) (on ?a ?b)) (at-end (on ?a ?b)))))",
        "(exists (?b - Sofa) (exists (?a - Mug) (and (before (clean ?a) (on ?a ?b)) (at-end (not (on ?a ?b))))))"}) {
    EXPECT_LT(goals(kCleanThenPlaced, other), 1) << other;
    EXPECT_GT(goals(kCleanThenPlaced, other), 0.4) << other;
  }
  EXPECT_LT(goals("(at-end (count = 2 (?a - Mug) (clean ?a)))", "(at-end (count = 3 (?a - Mug) (clean ?a)))"), 1);
  EXPECT_LT(goals("(at-end (count = 2 (?a - Mug) (clean ?a)))", "(at-end (count >= 2 (?a - Mug) (clean ?a)))"), 1);
  EXPECT_LT(
      goals("(exists (?a - (Mug :where (dirty ?a))) (at-end (clean ?a)))", "(exists (?a - Mug) (at-end (clean ?a)))"),
      1);
}

TEST(LikenessOfGoals, OtherCategoriesLeaveOnlyTheFormInCommon) {
  const double other_mug = goals("(exists (?a - Mug) (at-end (clean ?a)))", "(exists (?a - Cup) (at-end (clean ?a)))");
  EXPECT_NEAR(other_mug, 1.0 / 3, 1e-12);  // "at-end" of "exists", "at-end", "clean"
  EXPECT_EQ(goals("(exists (?a - Mug) (at-end (clean ?a)))", "(always (forall (?a - Cup) (dirty ?a)))"), 0);
}

TEST(LikenessOfTexts, ArticlesCaseAndPunctuationDoNotCount) {
  EXPECT_EQ(texts("Put a mug on the sofa.", "put the mug, on a Sofa"), 1);
  EXPECT_EQ(texts("", "The"), 1);
  EXPECT_EQ(texts("", "mug"), 0);
}

TEST(LikenessOfTexts, CountsTheWordsThatDiffer) {
  EXPECT_EQ(texts("Put the mug on the sofa.", "Put the cup on the sofa."), 0.75);
  EXPECT_EQ(texts("Put the mug on the sofa.", "Please put the mug on the sofa."), 0.8);
  EXPECT_EQ(texts("Put the mug on the sofa.", "On the sofa put the mug."), 0);  // the order counts
  EXPECT_EQ(texts("Put the mug on the sofa.", "Wash all plates"), 0);
}

TEST(LikenessOfTexts, IsExactWhereItIsAboveTheFloor) {
  Rng rng(1);
  const auto draw = [&rng] {
    std::vector<std::string> words;
    for (std::size_t n = rng.below(8); n > 0; --n) words.push_back("word" + std::to_string(rng.below(6)));
    return print_of_text(join(words, " "));
  };
  int above = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto a = draw(), b = draw();
    const double exact = likeness_of_texts(a, b, -1), floor = rng.unit();
    const double found = likeness_of_texts(a, b, floor);
    if (exact > floor) {
      EXPECT_EQ(found, exact);
      ++above;
    } else {
      EXPECT_LE(found, floor);
    }
  }
  EXPECT_GT(above, 100);
}

}  // namespace
}  // namespace unietp
