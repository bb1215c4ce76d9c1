#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "logic/formula_reading.h"

namespace unietp {
namespace {

struct BadFormula {
  FormulaUse use;
  std::string_view text;
  std::string_view message;
};

constexpr FormulaUse kGoal = FormulaUse::Goal, kState = FormulaUse::State;

const BadFormula kBadFormulas[] = {
    {kGoal, "(at-end (exists (?x - A) (open ?x))", "g:1:36: parse error: missing ')' for the '(' at line 1, column 1"},
    {kGoal, "(at-end (exists (?x - A) (open ?x))))", "g:1:37: parse error: unexpected ')' without '('"},
    {kGoal, "", "g:1:1: parse error: expected an expression, found nothing"},
    {kGoal, "(and) (or)", "g:1:7: parse error: expected one expression, found a second"},
    {kGoal, "open", "g:1:1: parse error: expected a formula in brackets such as (open ?x), found 'open'"},
    {kGoal, "(at-end ())", "g:1:9: parse error: empty brackets; expected an operator or a predicate after '('"},
    {kGoal, "((and))",
     "g:1:2: parse error: expected the name of an operator or a predicate after '(', found '(and …)'"},
    {kGoal, "(at-end\n  (exists (?x - A)\n    (opn ?x)))",
     "g:3:6: parse error: unknown operator or predicate 'opn'; did you mean 'open'?"},
    {kGoal, "(sometimes (and))",
     "g:1:2: parse error: unknown operator or predicate 'sometimes'; did you mean 'sometime'?"},
    {kGoal, "(qqqqqqqq ?x)",
     "g:1:2: parse error: unknown operator or predicate 'qqqqqqqq'; accepted are the operators =, and, or, not, imply, "
     "forall, exists, count, number, at-end, sometime, always, until, before and the predicates of docs/logic.md"},
    {kGoal, "(at-end (open ?x))",
     "g:1:15: parse error: the variable ?x is not bound here; bind it with forall, exists or count"},
    {kGoal, "(exists (?x - A) (at-end (open ?y)))",
     "g:1:32: parse error: the variable ?y is not bound here; bound are ?x"},
    {kGoal, "(exists (?x - A) (open ?x))",
     "g:1:18: parse error: 'open' is outside every temporal operator; in a goal, put it under at-end, sometime, "
     "always, until or before"},
    {kState, "(exists (?x - A) (sometime (open ?x)))",
     "g:1:18: parse error: the temporal operator 'sometime' is not allowed here; this formula is evaluated in a single "
     "state"},
    {kGoal, "(exists (?x - (A :where (always (open ?x)))) (at-end (hot ?x)))",
     "g:1:25: parse error: the temporal operator 'always' is not allowed here; a :where is evaluated only in the first "
     "state"},
    {kState, "(exists (?x - (A :where (open ?x))) (hot ?x))",
     "g:1:18: parse error: a :where is not allowed here; a formula that is evaluated in a single state has none"},
    {kGoal, "(exists (?x - A) (at-end (on ?x)))",
     "g:1:26: parse error: 'on' takes 2 arguments, found 1; write (on ?x ?y)"},
    {kGoal, "(exists (?x - A) (at-end (open ?x ?x)))",
     "g:1:26: parse error: 'open' takes 1 argument, found 2; write (open ?x)"},
    {kGoal, "(exists (?x - A) (at-end (filled ?x)))",
     "g:1:26: parse error: 'filled' takes 2 arguments, found 1; write (filled ?x water)"},
    {kGoal, "(exists (?x - A) (at-end (filled ?x ?x)))",
     "g:1:37: parse error: the second argument of 'filled' must be a word such as water, found '?x'"},
    {kGoal, "(exists (?x - A) (at-end (open x)))",
     "g:1:32: parse error: the first argument of 'open' must be a variable such as ?x, found 'x'; did you mean '?x'?"},
    {kGoal, "(exists (?r - room) (at-end (open ?r)))",
     "g:1:35: parse error: the first argument of 'open' must be an object; ?r ranges over rooms"},
    {kGoal, "(exists (?x - object) (exists (?y - A/slice) (at-end (in_room ?x ?y))))",
     "g:1:66: parse error: the second argument of 'in_room' must be a room; ?y ranges over objects"},
    {kGoal, "(at-end (exists (?x - A) (on agent ?x)))",
     "g:1:30: parse error: the first argument of 'on' cannot be the agent; 'agent' is allowed only as the first "
     "argument of 'in_room'"},
    {kGoal, "(exists (?x - A) (forall (?x - B) (at-end (open ?x))))",
     "g:1:27: parse error: the variable ?x is already bound here; choose another name"},
    {kGoal, "(at-end (exists ?x (open ?x)))",
     "g:1:17: parse error: expected a variable and its domain such as (?x - Mug), found '?x'"},
    {kGoal, "(at-end (exists (?x - (A B)) (open ?x)))",
     "g:1:23: parse error: expected a domain: a category, A/slice, object, room, agent, (either A B) or (A :where f), "
     "found '(A …)'"},
    {kGoal, "(at-end (exists (?x - A/half) (open ?x)))",
     "g:1:23: parse error: expected a category or a category with /slice, found 'A/half'"},
    {kGoal, "(at-end (exists (?x - (either)) (open ?x)))", "g:1:23: parse error: 'either' takes at least one category"},
    {kGoal, "(at-end (exists (?x - (either A room)) (open ?x)))",
     "g:1:33: parse error: 'room' is not allowed in 'either'; expected a category"},
    {kGoal, "(at-end (exists (?x - (A :where)) (open ?x)))",
     "g:1:26: parse error: ':where' takes one formula, found 0; write (A :where f)"},
    {kGoal, "(at-end (count => 2 (?x - A) (open ?x)))",
     "g:1:16: parse error: expected a comparison (=, >=, <=, > or <) after 'count', found '=>'"},
    {kGoal, "(at-end (count >= two (?x - A) (open ?x)))",
     "g:1:19: parse error: expected a whole number from 0 after the comparison, found 'two'"},
    {kGoal, "(at-end (count >= 02 (?x - A) (open ?x)))",
     "g:1:19: parse error: expected a whole number from 0 after the comparison, found '02'"},
    {kGoal, "(at-end (count >= -1 (?x - A) (open ?x)))",
     "g:1:19: parse error: expected a whole number from 0 after the comparison, found '-1'"},
    {kGoal, "(at-end (count >= 99999999999 (?x - A) (open ?x)))",
     "g:1:19: parse error: expected a whole number from 0 after the comparison, found '99999999999'"},
    {kGoal, "(at-end (count >= 2))",
     "g:1:9: parse error: 'count' takes 3 or 4 parts, found 2; write (count >= 2 (?x - D) f) or "
     "(count > (number (?x - D) f) (number (?y - E) g))"},
    {kGoal, "(at-end (count > (?x - A) (open ?x) (?y - B)))",
     "g:1:37: parse error: expected (number (?y - D) g) to compare with, found '(?y …)'"},
    {kGoal, "(at-end (number (?x - A) (open ?x)))",
     "g:1:9: parse error: 'number' is allowed only inside a count: (count > (number (?x - A) f) (number (?y - B) g))"},
    {kGoal, "(not)", "g:1:1: parse error: 'not' takes 1 part, found 0; write (not f)"},
    {kGoal, "(until (and))", "g:1:1: parse error: 'until' takes 2 parts, found 1; write (until f g)"},
    {kGoal, "(exists (?x - A) (= ?x red))",
     "g:1:24: parse error: the second part of '=' must be a variable such as ?x, found 'red'"},
    {kGoal, "(exists (?x - A) (at-end (filled ?x \"water)))", "g:1:37: parse error: this string has no closing '\"'"},
};

TEST(ParseFormula, RefusesBadInputWithAWholeMessage) {
  for (const auto& bad : kBadFormulas) {
    const auto parsed = parse_formula("g", bad.text, bad.use);
    ASSERT_FALSE(parsed) << bad.text;
    EXPECT_EQ(format(parsed.error()), bad.message) << bad.text;
  }
}

std::vector<std::string> all_problems(std::string_view text) {
  const auto expression = read_sexpr("g", text);
  EXPECT_TRUE(expression);
  std::vector<std::string> found;
  const auto reading = read_formula("g", *expression, FormulaUse::Goal);
  EXPECT_NE(reading.formula.has_value(), !reading.errors.empty()) << text;
  for (const auto& error : reading.errors) found.push_back(format(error).substr(2));
  return found;
}

TEST(ReadFormula, TellsAllProblemsAtOnceInOrderOfPosition) {
  using ::testing::ElementsAre;
  using ::testing::StartsWith;
  EXPECT_THAT(all_problems("(and (at-end (opn ?x))\n"
                           "     (exists (?c - C) (at-end (closed ?d) (open ?c)))\n"
                           "     (open ?c)\n"
                           "     (exists (?a - (either A A)) (sometme (inside ?a)))\n"
                           "     (at-end (count => two (?b - B) (hot ?b ?b))))"),
              ElementsAre(StartsWith("1:15: parse error: unknown operator or predicate 'opn'"),
                          StartsWith("2:23: parse error: 'at-end' takes 1 part, found 2"),
                          StartsWith("2:39: parse error: the variable ?d is not bound here"),
                          StartsWith("3:6: parse error: 'open' is outside every temporal operator"),
                          StartsWith("3:12: parse error: the variable ?c is not bound here"),
                          StartsWith("4:30: parse error: 'A' occurs twice in this 'either'"),
                          StartsWith("4:35: parse error: unknown operator or predicate 'sometme'"),
                          StartsWith("4:43: parse error: 'inside' takes 2 arguments, found 1"),
                          StartsWith("5:21: parse error: expected a comparison"),
                          StartsWith("5:24: parse error: expected a whole number from 0"),
                          StartsWith("5:37: parse error: 'hot' takes 1 argument, found 2")));
}

TEST(ReadFormula, ABadDomainIsNoReasonToCallItsVariableUnbound) {
  using ::testing::ElementsAre;
  using ::testing::StartsWith;
  EXPECT_THAT(all_problems("(exists (?x - A/half) (at-end (open ?x)))"), ElementsAre(StartsWith("1:15:")));
  EXPECT_THAT(all_problems("(exists (?x A) (at-end (open ?x)))"), ElementsAre(StartsWith("1:9:")));
  EXPECT_THAT(all_problems("(exists ?x (at-end (open ?x)))"), ElementsAre(StartsWith("1:9:")));
}

TEST(ReadFormula, AMisspelledVariableIsAnsweredWithTheNearest) {
  EXPECT_THAT(all_problems("(exists (?mug - A) (at-end (open ?muug)))"),
              ::testing::ElementsAre("1:34: parse error: the variable ?muug is not bound here; bound are ?mug; did you "
                                     "mean '?mug'?"));
}

TEST(ParseFormula, TakesPlaceholdersWhereCategoriesAndSymbolsStand) {
  for (const char* text :
       {"(exists (?x - A) (at-end (filled ?x S)))", "(exists (?x - coffee_table.n.01) (at-end (dirty ?x)))",
        "(exists (?r - R) (at-end (in_room agent ?r)))",
        "(exists (?g - agent) (exists (?r - room) (sometime (in_room ?g ?r))))"}) {
    const auto parsed = parse_formula("g", text, FormulaUse::Goal);
    ASSERT_TRUE(parsed) << format(parsed.error());
    EXPECT_EQ(to_text(*parsed), text);
  }
}

TEST(ParseFormula, ReadsAFormulaInsideALargerFileWithItsOuterVariables) {
  const auto file = read_sexprs("t.template", "(goal\n  (at-end (open ?x)))");
  ASSERT_TRUE(file);
  const Sexpr& inner = file->front().children[1];
  const auto parsed = parse_formula("t.template", inner, FormulaUse::Goal, {"x"});
  ASSERT_TRUE(parsed);
  EXPECT_EQ(free_variables(*parsed), std::vector<std::string>{"x"});
  const auto unbound = parse_formula("t.template", inner, FormulaUse::Goal);
  ASSERT_FALSE(unbound);
  EXPECT_EQ(unbound.error().pos, (SourcePos{2, 17}));
}

}  // namespace
}  // namespace unietp
