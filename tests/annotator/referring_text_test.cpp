#include <gtest/gtest.h>

#include <set>

#include "annotator/meaning.h"
#include "small_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using testing_support::asking;
using testing_support::small_knowledge;

struct Saying {
  std::string goal;
  std::vector<std::string> start;
  std::string style;
  std::set<std::string> words;  // each comes up in some text
};

/// Many texts of a goal: each reads back, and the expected words are among them.
void expect_says(const Saying& saying) {
  SCOPED_TRACE(saying.goal);
  auto specification = asking(saying.goal, saying.style.empty() ? "direct" : saying.style);
  for (const auto& text : saying.start) {
    const auto formula = parse_formula("test", text, FormulaUse::State);
    ASSERT_TRUE(formula) << format(formula.error());
    specification.init.push_back(*formula);
  }
  const Knowledge knowledge = small_knowledge();
  const NounTable nouns(knowledge, committed_names());
  std::string texts;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    const auto written = write_instruction(specification, knowledge, nouns, {Phrasings::All, {}, nullptr}, Rng(seed));
    ASSERT_TRUE(written) << format(written.error());
    if (!saying.style.empty()) {
      EXPECT_EQ(name_of(written->style), saying.style) << written->text;
    }
    EXPECT_TRUE(check_instruction(written->text, specification, small_knowledge()).empty()) << written->text;
    texts += written->text + "\n";
  }
  for (const auto& words : saying.words) EXPECT_NE(texts.find(words), std::string::npos) << words << " in\n" << texts;
}

std::string open_the(const std::string& where) {
  return "(exists (?a - (Lamp :where " + where + ")) (at-end (open ?a)))";
}

TEST(ReferringText, NamesEachKindAsPeopleDo) {
  expect_says({open_the("(exists (?p - Table) (nearest ?a ?p))"), {}, "", {"lamp nearest to the table"}});
  expect_says({open_the("(exists (?r - kitchen) (in_room ?a ?r))"), {}, "", {"the lamp in the kitchen"}});
  expect_says({open_the("(size ?a large)"), {}, "", {"the largest lamp", "the biggest lamp"}});
  expect_says({open_the("(size ?a small)"), {}, "", {"the smallest lamp"}});
  expect_says({open_the("(colour ?a red)"), {}, "", {"the red lamp", "that is red"}});
  expect_says({open_the("(material ?a wood)"), {}, "", {"the wooden lamp", "made of wood"}});
  expect_says({open_the("(exists (?p - Table) (next_to ?a ?p))"), {}, "", {"lamp next to", "that is next to"}});
  expect_says({open_the("(and (dirty ?a) (exists (?p - Table) (on ?a ?p)))"), {}, "", {"the dirty lamp"}});
  expect_says({open_the("(exists (?p - Bowl) (inside ?p ?a))"), {}, "", {"where a bowl is"}});
}

TEST(ReferringText, SaysTwoOnlyWhereTheStartHasTwo) {
  const std::string all = "(forall (?a - (Mug :where (dirty ?a))) (at-end (clean ?a)))";
  expect_says({all, {"(count = 2 (?x - Mug) (dirty ?x))"}, "", {"both dirty mugs"}});
  expect_says({open_the("(size ?a large)"), {"(count = 2 (?x - Lamp) (and))"}, "", {"the larger of the two lamps"}});
  const auto several = asking(all);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto written = write_instruction(several, small_knowledge(), Rng(seed));
    ASSERT_TRUE(written);
    EXPECT_EQ(written->text.find("both"), std::string::npos) << written->text;
  }
}

TEST(ReferringText, CountsAmongThoseThatAreMeant) {
  expect_says({"(exists (?b - Fridge) (at-end (count >= 2 (?a - (Mug :where (dirty ?a))) (inside ?a ?b))))",
               {},
               "",
               {"at least two of the"}});
}

TEST(ReferringText, TellsTwoOfOneCategoryApart) {
  expect_says(
      {"(exists (?a - (Mug :where (colour ?a red))) (exists (?d - (Mug :where (dirty ?d))) (exists (?b - Table) "
       "(exists (?c - Fridge) (at-end (and (on ?a ?b) (inside ?d ?c)))))))",
       {},
       "",
       {"red mug", "dirty mug"}});
}

TEST(Styles, EachKeepsItsPromise) {
  expect_says(
      {"(exists (?a - Mug) (exists (?b - Table) (exists (?c - Fridge) (and (before (open ?c) (on ?a ?b)) "
       "(at-end (and (on ?a ?b) (open ?c)))))))",
       {},
       "inverted-order",
       {"Before you put", "open"}});
  expect_says(
      {"(exists (?a - Mug) (exists (?b - Fridge) (and (before (inside ?a ?b) (power_on ?b)) (at-end (and (inside ?a "
       "?b) (power_on ?b))))))",
       {},
       "subordinate-clause",
       {" you've ", ", "}});
  expect_says({"(exists (?a - Mug) (exists (?b - Table) (at-end (and (hot ?a) (on ?a ?b)))))",
               {},
               "implicit-need",
               {"hot mug. ", " it on "}});
  expect_says({"(exists (?b - Fridge) (at-end (count >= 2 (?a - Mug) (inside ?a ?b))))",
               {},
               "vague-quantity",
               {"a couple of mugs"}});
  expect_says(
      {"(exists (?b - Fridge) (at-end (count >= 3 (?a - Mug) (inside ?a ?b))))", {}, "vague-quantity", {"a few mugs"}});
  expect_says(
      {"(exists (?c - (Fridge :where (exists (?b - Bowl) (inside ?b ?c)))) (exists (?a - Mug) (at-end (and "
       "(clean ?a) (inside ?a ?c)))))",
       {},
       "coreference",
       {"where a bowl is kept"}});
  expect_says(
      {"(exists (?a - Mug) (exists (?b - Table) (at-end (and (on ?a ?b) (forall (?c - CoffeeTable) (forall (?y - "
       "Mug) (not (on ?y ?c))))))))",
       {},
       "negation",
       {"no"}});
  expect_says(
      {"(exists (?a - Mug) (exists (?b - Fridge) (and (at-end (inside ?a ?b)) (always (forall (?d - Bowl) (exists "
       "(?c - Table) (on ?d ?c)))))))",
       {},
       "distractor",
       {"bowl"}});
}

TEST(Styles, OfInvertedOrderAsksForBoth) {
  const Specification task = asking(
      "(exists (?a - Fridge) (exists (?b - Lamp) (and (before (closed ?a) (power_on ?b)) "
      "(at-end (and (closed ?a) (power_on ?b))))))",
      "inverted-order");
  const Knowledge knowledge = small_knowledge();
  std::set<std::string> openings;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto written = write_instruction(task, knowledge, Rng(seed));
    ASSERT_TRUE(written) << format(written.error());
    EXPECT_EQ(written->style, Style::InvertedOrder) << written->text;
    const std::size_t but = written->text.find(", but ");
    ASSERT_NE(but, std::string::npos) << written->text;
    EXPECT_LT(written->text.find("on"), but) << written->text;
    openings.insert(written->text.substr(but, std::string(", but first").size()));
  }
  EXPECT_GT(openings.size(), 1U);  // "…, but close it first" and "…, but first close it"
  EXPECT_TRUE(check_instruction("Turn on a lamp, but close a fridge first.", task, knowledge).empty());
  EXPECT_TRUE(check_instruction("Before you turn on a lamp, close a fridge.", task, knowledge).empty());
  EXPECT_FALSE(check_instruction("Close a fridge, but turn on a lamp first.", task, knowledge).empty());
  EXPECT_FALSE(check_instruction("Turn on a lamp, but close a fridge.", task, knowledge).empty());
}

TEST(Styles, AreNotClaimedWhereAGoalHasNothingToSayThatWay) {
  for (const char* style : {"inverted-order", "subordinate-clause", "implicit-need", "vague-quantity", "coreference"}) {
    const auto written =
        write_instruction(asking("(exists (?a - Lamp) (at-end (open ?a)))", style), small_knowledge(), Rng(1));
    ASSERT_TRUE(written);
    EXPECT_EQ(written->style, Style::Direct) << written->text;
  }
}

}  // namespace
}  // namespace unietp
