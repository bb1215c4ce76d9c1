#include "logic/formula.h"

#include <gtest/gtest.h>

#include <set>

#include "logic/evaluate.h"
#include "random_goals.h"

namespace unietp {
namespace {

using testing::goal_of;
using testing::GoalWriter;

TEST(Formula, TextAndTreeAreInverseOnRandomFormulas) {
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    GoalWriter writer{Rng(seed)};
    const bool goal = seed % 2 == 0;
    const Formula formula = goal ? writer.goal() : writer.state_formula(4);
    const std::string text = to_text(formula);
    const auto parsed = parse_formula("random", text, goal ? FormulaUse::Goal : FormulaUse::State);
    // The writer does not know sorts: an `=` or a room may be refused, and then by its kind only.
    if (!parsed) {
      ASSERT_NE(parsed.error().message.find("ranges over"), std::string::npos) << format(parsed.error()) << text;
      continue;
    }
    ASSERT_EQ(*parsed, formula) << text;
    ASSERT_EQ(to_text(*parsed), text);
    texts.insert(text);
  }
  EXPECT_GT(texts.size(), 10000U);
}

TEST(Formula, BothShapesOfACountOfTwoCountsAreOne) {
  const Formula longer = goal_of("(at-end (count > (number (?x - A) (open ?x)) (number (?y - B) (open ?y))))");
  const Formula shorter = goal_of("(at-end (count > (?x - A) (open ?x) (number (?y - B) (open ?y))))");
  EXPECT_EQ(longer, shorter);
  EXPECT_EQ(to_text(shorter), "(at-end (count > (number (?x - A) (open ?x)) (number (?y - B) (open ?y))))");
}

TEST(Formula, BuildersGiveWhatTheParserGives) {
  EXPECT_EQ(exists("x", of_category("Mug"),
                   at_end(conjunction(
                       {atom(Predicate::Open, {"x"}), negation(atom_with_symbol(Predicate::Filled, "x", "water"))}))),
            goal_of("(exists (?x - Mug) (at-end (and (open ?x) (not (filled ?x water)))))"));
  EXPECT_EQ(conjunction({atom(Predicate::Open, {"x"})}), atom(Predicate::Open, {"x"}));
  EXPECT_EQ(forall("x", of_category("Mug"), at_end(atom(Predicate::Hot, {"x"}))),
            goal_of("(forall (?x - Mug) (at-end (hot ?x)))"));
}

TEST(Formula, NamesItsCategoriesAndFreeVariables) {
  const Formula goal =
      goal_of("(exists (?x - (either B A/slice)) (forall (?y - (C :where (on ?y ?x))) (at-end (on ?y ?x))))");
  EXPECT_EQ(categories_of(goal), (std::vector<std::string>{"A", "B", "C"}));
  EXPECT_TRUE(free_variables(goal).empty());
  EXPECT_EQ(free_variables(goal.children.front()), std::vector<std::string>{"x"});
}

TEST(SubstituteNames, BindsPlaceholdersOfDomainsAndSymbols) {
  const Formula goal =
      goal_of("(exists (?x - A/slice) (exists (?y - (B :where (colour ?y C))) (at-end (filled ?y S))))");
  const Formula bound = substitute_names(
      goal, {{"A", {"Apple"}}, {"B", {"Mug", "Cup", "Mug"}}, {"S", {"water", "milk"}}, {"C", {"red"}}});
  EXPECT_EQ(to_text(bound),
            "(exists (?x - Apple/slice) (exists (?y - ((either Mug Cup) :where (colour ?y red))) "
            "(at-end (or (filled ?y water) (filled ?y milk)))))");
  EXPECT_EQ(substitute_names(goal, {}), goal);
}

TEST(RenameVariable, RenamesFreeUsesOnlyAndCapturesNothing) {
  const Formula f = goal_of("(exists (?a - A) (exists (?b - (B :where (on ?b ?a))) (at-end (on ?a ?b))))").children[0];
  EXPECT_EQ(to_text(rename_variable(f, "a", "c")), "(exists (?b - (B :where (on ?b ?c))) (at-end (on ?c ?b)))");
  EXPECT_EQ(to_text(rename_variable(f, "a", "b")), "(exists (?b_ - (B :where (on ?b_ ?b))) (at-end (on ?b ?b_)))");
  EXPECT_EQ(rename_variable(f, "b", "z"), f);
}

struct SameMeaning {
  std::string_view left, right;
};

TEST(NormalForm, IsEqualForFormulasThatDifferInNamesOrderNestingAndDoubleNegation) {
  const SameMeaning pairs[] = {
      {"(exists (?x - A) (at-end (open ?x)))", "(exists (?mug - A) (at-end (open ?mug)))"},
      {"(at-end (exists (?x - A) (and (open ?x) (hot ?x))))", "(at-end (exists (?v0 - A) (and (hot ?v0) (open ?v0))))"},
      {"(exists (?x - A) (and (at-end (open ?x)) (and (sometime (hot ?x)) (always (clean ?x)))))",
       "(exists (?x - A) (and (and (always (clean ?x)) (at-end (open ?x))) (sometime (hot ?x))))"},
      {"(exists (?x - A) (not (not (at-end (open ?x)))))", "(exists (?x - A) (at-end (open ?x)))"},
      {"(exists (?x - A) (exists (?y - B) (at-end (on ?x ?y))))",
       "(exists (?y - B) (exists (?x - A) (at-end (on ?x ?y))))"},
      {"(exists (?x - A) (exists (?y - A) (at-end (on ?x ?y))))",
       "(exists (?x - A) (exists (?y - A) (at-end (on ?y ?x))))"},
      {"(forall (?x - A) (forall (?y - A) (forall (?z - A) (at-end (or (on ?x ?y) (on ?y ?z))))))",
       "(forall (?c - A) (forall (?b - A) (forall (?a - A) (at-end (or (on ?b ?c) (on ?a ?b))))))"},
      {"(exists (?x - A) (and (exists (?y - B) (at-end (on ?x ?y)))))",
       "(exists (?y - B) (not (not (exists (?x - A) (at-end (on ?x ?y))))))"},
      {"(exists (?c - C) (exists (?x - (A :where (inside ?x ?c))) (at-end (on ?x ?c))))",
       "(exists (?v1 - C) (exists (?v0 - (A :where (inside ?v0 ?v1))) (at-end (on ?v0 ?v1))))"},
      {"(exists (?x - A) (exists (?y - A) (at-end (not (= ?x ?y)))))",
       "(exists (?x - A) (exists (?y - A) (at-end (not (= ?y ?x)))))"},
      {"(at-end (count >= 2 (?x - (either A B)) (open ?x)))",
       "(at-end (count >= 2 (?y - (either B A)) (and (open ?y))))"},
  };
  for (const auto& pair : pairs) {
    EXPECT_EQ(to_text(normal_form(goal_of(pair.left))), to_text(normal_form(goal_of(pair.right)))) << pair.left;
  }
}

TEST(NormalForm, KeepsApartWhatMeansSomethingElse) {
  const SameMeaning pairs[] = {
      {"(exists (?x - A) (forall (?y - B) (at-end (on ?x ?y))))",
       "(forall (?y - B) (exists (?x - A) (at-end (on ?x ?y))))"},
      {"(exists (?x - A) (before (open ?x) (hot ?x)))", "(exists (?x - A) (before (hot ?x) (open ?x)))"},
      {"(exists (?x - A) (exists (?y - A) (at-end (on ?x ?y))))",
       "(exists (?x - A) (exists (?y - A) (at-end (on ?x ?x))))"},
      {"(at-end (count >= 2 (?x - A) (open ?x)))", "(at-end (count > 2 (?x - A) (open ?x)))"},
  };
  for (const auto& pair : pairs)
    EXPECT_NE(normal_form(goal_of(pair.left)), normal_form(goal_of(pair.right))) << pair.left;
}

TEST(NormalForm, KeepsTheTruthOfRandomFormulasAndIsItsOwnNormalForm) {
  int all_true = 0;
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    GoalWriter writer(Rng(seed).fork("normal", 0));
    const Formula goal = writer.goal();
    const Formula normal = normal_form(goal);
    ASSERT_EQ(normal_form(normal), normal) << to_text(goal);
    for (std::uint64_t i = 0; i < 4; ++i) {
      const Trace trace = testing::random_trace(Rng(seed).fork("trace", i));
      const bool expected = holds(goal, trace);
      ASSERT_EQ(holds(normal, trace), expected) << to_text(goal) << "\n" << to_text(normal);
      all_true += expected ? 1 : 0;
    }
  }
  EXPECT_GT(all_true, 4000);
}

TEST(NormalForm, FreeVariablesKeepTheirNames) {
  const auto formula = parse_formula("t", *read_sexpr("t", "(exists (?x - A) (on ?x ?v0))"), FormulaUse::State, {"v0"});
  ASSERT_TRUE(formula);
  EXPECT_EQ(free_variables(normal_form(*formula)), std::vector<std::string>{"v0"});
}

}  // namespace
}  // namespace unietp
