#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "../logic/random_goals.h"
#include "annotator/equivalence.h"
#include "annotator/meaning.h"
#include "small_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using testing_support::asking;
using testing_support::small_knowledge;

/// Names for the two categories of the random goals; of the second there is no plural.
Knowledge two_categories() {
  Category apple, bread;
  apple.name = "A";
  apple.display = "apple";
  apple.plural = "apples";
  apple.countable = true;
  bread.name = "B";
  bread.display = bread.plural = "bread";
  bread.countable = false;
  return Knowledge(Simulator::Ai2thor, {apple, bread}, {}, {}, {}, {});
}

void collect(const Formula& formula, std::set<Formula::Op>& into) {
  into.insert(formula.op);
  for (const Formula& child : formula.children) collect(child, into);
}

std::string words_of(const Formula& goal, const Knowledge& knowledge, std::uint64_t seed) {
  Specification specification = asking("");
  specification.goal = goal;
  const auto text = write_instruction(specification, knowledge, Rng(seed));
  EXPECT_TRUE(text) << to_text(goal) << "\n" << format(text.error());
  return text ? text->text : "";
}

void expect_reads_back(const Formula& goal, const Knowledge& knowledge, std::uint64_t seed) {
  const std::string text = words_of(goal, knowledge, seed);
  SCOPED_TRACE(text);
  const auto read = parse_instruction(text, knowledge);
  ASSERT_TRUE(read) << format(read.error());
  EXPECT_TRUE(same_meaning(*read, goal)) << to_text(*read) << "\n" << to_text(goal);
  EXPECT_FALSE(distinguishing_trace(*read, goal, 20, Rng(seed))) << to_text(*read) << "\n" << to_text(goal);
}

TEST(EveryGoal, HasWordsThatReadBackAsIt) {
  const Knowledge knowledge = two_categories();
  std::set<Formula::Op> met;
  const char* asked = std::getenv("UNIETP_GOALS");  // more than the usual number, for a long run
  const std::uint64_t goals = asked == nullptr ? 600 : std::stoull(asked);
  for (std::uint64_t seed = 0; seed < goals; ++seed) {
    SCOPED_TRACE(seed);
    const Formula goal = ::unietp::testing::GoalWriter(Rng(seed)).goal();
    collect(goal, met);
    expect_reads_back(goal, knowledge, seed);
  }
  EXPECT_EQ(met.size(), static_cast<std::size_t>(Formula::Op::Before) + 1) << "not every operator was met";
}

TEST(EveryGoal, LinksTheLastOfThreePartsByAnd) {
  const Knowledge knowledge = two_categories();
  int met = 0;
  for (std::uint64_t seed = 0; seed < 600 && met < 5; ++seed) {
    const std::string text = words_of(::unietp::testing::GoalWriter(Rng(seed)).goal(), knowledge, seed);
    const auto list = text.find("all three of these hold: ");
    if (list == std::string::npos) continue;
    ++met;
    EXPECT_NE(text.find(", and ", list), std::string::npos) << text;
  }
  EXPECT_EQ(met, 5);
}

TEST(EveryGoal, SpeaksOfEveryPredicateOverTime) {
  const Knowledge knowledge = small_knowledge();
  for (const PredicateInfo& predicate : all_predicates()) {
    std::string fact = "(" + std::string(predicate.name) + " ?x";
    if (predicate.arguments.size() > 1) fact += predicate.arguments[1] == ArgumentKind::Symbol ? " red" : " ?y";
    fact += ")";
    const bool room = predicate.arguments.size() > 1 && predicate.arguments[1] == ArgumentKind::Room;
    const auto goal = parse_formula("test",
                                    "(exists (?x - Mug) (forall (?y - " + std::string(room ? "kitchen" : "Fridge") +
                                        ") (always (imply " + fact + " (sometime (not " + fact + "))))))",
                                    FormulaUse::Goal);
    ASSERT_TRUE(goal) << format(goal.error());
    expect_reads_back(*goal, knowledge, 1);
  }
}

TEST(EveryGoal, SpeaksOfTheAgentAndOfRooms) {
  for (const char* goal :
       {"(always (imply (exists (?r - kitchen) (in_room agent ?r)) (exists (?m - Mug) (held ?m))))",
        "(forall (?r - room) (sometime (in_room agent ?r)))",
        "(exists (?a - agent) (forall (?r - kitchen) (until (in_room ?a ?r) (exists (?m - Mug) (on_floor ?m ?r)))))"}) {
    const auto read = parse_formula("test", goal, FormulaUse::Goal);
    ASSERT_TRUE(read) << format(read.error());
    expect_reads_back(*read, small_knowledge(), 2);
  }
}

TEST(EveryGoal, SaysPlainlyWhatCanBeSaidPlainly) {
  const auto goal = parse_formula("test",
                                  "(exists (?m - Mug) (exists (?t - Table) (and (at-end (on ?m ?t)) "
                                  "(always (imply (hot ?m) (sometime (held ?m)))))))",
                                  FormulaUse::Goal);
  ASSERT_TRUE(goal) << format(goal.error());
  const std::string text = words_of(*goal, small_knowledge(), 4);
  EXPECT_THAT(text, ::testing::ContainsRegex("(Put|Place|Set) a mug on a table"));
  EXPECT_NE(text.find("if the mug is "), std::string::npos) << text;
  EXPECT_EQ(text.find("for some"), std::string::npos) << text;
}

TEST(EveryGoal, TellsThenFromLaterByWordsOfTheirOwn) {
  const std::string goal = "(exists (?m - Mug) (always (imply (hot ?m) (sometime (clean ?m)))))";
  const auto text = words_of(*parse_formula("test", goal, FormulaUse::Goal), small_knowledge(), 1);
  EXPECT_NE(text.find("at that time or later, the mug is clean"), std::string::npos) << text;
  EXPECT_FALSE(parse_instruction("Make sure of this: at that time or later, anything goes.", small_knowledge()));
  EXPECT_FALSE(parse_instruction("Make sure of this: at all times, at some point, anything goes.", small_knowledge()));
}

TEST(EveryGoal, IsRefusedInWordsThatLeaveOpenWhatIsMeant) {
  for (const char* text :
       {"Make sure of this: the mug is hot.", "Make sure of this: a mug is hot.",
        "Make sure of this: for some mug, for some mug, the mug is hot.",
        "Make sure of this: for some mug, the third mug is hot.", "Make sure of this: for no mug, the mug is hot.",
        "Make sure of this: all three of these hold: anything goes, and anything goes.",
        "Make sure of this: both anything goes."})
    EXPECT_FALSE(parse_instruction(text, small_knowledge())) << text;
  std::string deep = "Make sure of this: ";
  for (int i = 0; i < 5000; ++i) deep += "it is not so that ";
  const auto read = parse_instruction(deep + "anything goes.", small_knowledge());
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("less nesting"), std::string::npos) << read.error().message;
}

}  // namespace
}  // namespace unietp
