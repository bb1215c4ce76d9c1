#include "core/sexpr.h"

#include <gtest/gtest.h>

#include "core/limits.h"

namespace unietp {
namespace {

TEST(ReadSexprs, GivesAtomsStringsAndListsWithTheirPositions) {
  const auto all = read_sexprs("f", "; a comment (\n(on ?x\n  \"a \\\"b\\\"\\n\\\\\") atom;end\n");
  ASSERT_TRUE(all) << format(all.error());
  ASSERT_EQ(all->size(), 2U);
  const Sexpr& list = (*all)[0];
  EXPECT_TRUE(list.is_form("on"));
  EXPECT_FALSE(list.is_form("?x"));
  EXPECT_EQ(list.pos, (SourcePos{2, 1}));
  EXPECT_EQ(list.end, (SourcePos{3, 16}));
  ASSERT_EQ(list.children.size(), 3U);
  EXPECT_TRUE(list.children[1].is_atom("?x"));
  EXPECT_EQ(list.children[1].pos, (SourcePos{2, 5}));
  EXPECT_EQ(list.children[1].end, (SourcePos{2, 6}));
  EXPECT_EQ(list.children[2].kind, Sexpr::Kind::String);
  EXPECT_EQ(list.children[2].text, "a \"b\"\n\\");
  EXPECT_EQ(list.children[2].pos, (SourcePos{3, 3}));
  EXPECT_TRUE((*all)[1].is_atom("atom"));
  EXPECT_EQ((*all)[1].pos, (SourcePos{3, 18}));
}

TEST(ReadSexprs, StartsCountingWhereItIsTold) {
  const auto one = read_sexpr("f", "\n (a)", {10, 5});
  ASSERT_TRUE(one);
  EXPECT_EQ(one->pos, (SourcePos{11, 2}));
  EXPECT_EQ(read_sexpr("f", "(a)", {10, 5})->pos, (SourcePos{10, 5}));
}

TEST(ReadSexprs, NothingIsNoExpression) {
  EXPECT_TRUE(read_sexprs("f", " ; only a comment")->empty());
  EXPECT_EQ(format(read_sexpr("f", " ").error()), "f:1:1: parse error: expected an expression, found nothing");
}

TEST(ReadSexprs, SaysWhereItCannotGoOn) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"(a\n(b)", "f:2:4: parse error: missing ')' for the '(' at line 1, column 1"},
      {"a)", "f:1:2: parse error: unexpected ')' without '('"},
      {"(a \"b)", "f:1:4: parse error: this string has no closing '\"'"},
      {R"("\t")", R"(f:1:2: parse error: unknown escape; accepted are \", \\ and \n)"},
  };
  for (const auto& [text, message] : cases) {
    const auto result = read_sexprs("f", text);
    ASSERT_FALSE(result) << text;
    EXPECT_EQ(format(result.error()), message);
  }
  EXPECT_EQ(format(read_sexpr("f", "a b").error()), "f:1:3: parse error: expected one expression, found a second");
}

TEST(ReadSexprs, RefusesNestingThatWouldExhaustTheStack) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '(') + std::string(depth, ')'); };
  EXPECT_TRUE(read_sexprs("f", nested(200)));
  const auto deep = read_sexprs("f", nested(100000));
  ASSERT_FALSE(deep);
  EXPECT_EQ(deep.error().message, "brackets are nested deeper than 200");
}

TEST(Sexpr, MoreThanAreReadAreRefused) {
  std::string text;
  for (std::size_t i = 0; i + 1 < limits::kExpressions; ++i) text += "a ";
  EXPECT_TRUE(read_sexpr("x", "(" + text + ")"));
  const auto more = read_sexpr("x", "(a " + text + ")");
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().message, "more than 20000 lists and words");
}

}  // namespace
}  // namespace unietp
