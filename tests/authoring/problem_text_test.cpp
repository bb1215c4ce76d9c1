#include "authoring/problem_text.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

LintProblem at(int line, int column, bool warning = false) {
  return {{Error::Kind::Schema, "a.template", {line, column}, "something is wrong"}, warning};
}

TEST(ProblemText, ACaretStandsUnderThePlace) {
  EXPECT_EQ(problem_text(at(2, 4), "first\n  (opn ?a)\nlast", false),
            "a.template:2:4: schema error: something is wrong\n"
            "    2 |   (opn ?a)\n"
            "      |    ^\n");
}

TEST(ProblemText, ColumnsAreBytesAndTheCaretCountsCharacters) {
  EXPECT_EQ(problem_text(at(1, 7), "\"\u00e9\u00e9\" x", false),
            "a.template:1:7: schema error: something is wrong\n"
            "    1 | \"\u00e9\u00e9\" x\n"
            "      |     ^\n");
}

TEST(ProblemText, AWarningIsCalledOneAndColorIsOnlyGivenWhenAsked) {
  const auto plain = problem_text(at(1, 1, true), "x", false);
  EXPECT_TRUE(plain.starts_with("a.template:1:1: warning: something is wrong\n")) << plain;
  EXPECT_EQ(plain.find('\033'), std::string::npos);
  EXPECT_NE(problem_text(at(1, 1), "x", true).find("\033[31mschema error:\033[0m"), std::string::npos);
}

TEST(ProblemText, ALongLineIsCutAroundThePlace) {
  const auto text = problem_text(at(1, 501), std::string(500, 'a') + "!" + std::string(500, 'b'), false);
  const auto bar = text.find(" | ");
  const auto line = text.substr(bar + 3, text.find('\n', bar) - bar - 3);
  EXPECT_LT(line.size(), 120U);
  const auto caret_line = text.substr(text.find('\n', bar) + 1);
  EXPECT_EQ(line.at(caret_line.find('^') - caret_line.find(" | ") - 3), '!');
}

TEST(ProblemText, APlaceThatIsNotInTheTextShowsNoLine) {
  EXPECT_EQ(problem_text(at(0, 0), "x", false), "a.template: schema error: something is wrong\n");
  EXPECT_EQ(problem_text(at(9, 1), "x", false), "a.template:9:1: schema error: something is wrong\n");
  EXPECT_EQ(problem_text(at(1, 40), "x", false),
            "a.template:1:40: schema error: something is wrong\n    1 | x\n      |  ^\n");
}

TEST(ProblemText, BytesThatMoveTheCursorAreNotPrinted) {
  EXPECT_EQ(problem_text(at(1, 3), "a\tb\033[2J", false),
            "a.template:1:3: schema error: something is wrong\n"
            "    1 | a b.[2J\n"
            "      |   ^\n");
}

}  // namespace
}  // namespace unietp
