// A text with one word changed that asks for another goal.
#include "annotator/minimal_pair.h"

#include <gtest/gtest.h>

#include "annotator/instruction.h"
#include "core/text.h"
#include "small_knowledge.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using testing_support::asking;

Scene kitchen_with(std::initializer_list<const char*> kinds) {
  Scene home;
  for (const char* kind : kinds) {
    Node node;
    node.id = lower(kind) + "_" + std::to_string(home.nodes.size() + 1);
    node.category = kind;
    home.nodes.push_back(node);
  }
  return home;
}

TEST(MinimalPair, DiffersInOneWordAndEachTextMeansItsGoalAlone) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const NounTable nouns(knowledge, committed_names());
  const Scene home = kitchen_with({"Mug", "Bowl", "Plate", "DiningTable"});
  const auto task = asking("(exists (?m - Mug) (exists (?t - DiningTable) (at-end (on ?m ?t))))");
  const std::string text = "Put the mug on the dining table.";
  ASSERT_TRUE(check_instruction(text, task, knowledge, nouns, &home).empty());
  int found = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto pair = minimal_pair(text, task, knowledge, nouns, home, Rng(seed));
    if (!pair) continue;
    ++found;
    const auto words = split(text, ' '), others = split(pair->text, ' ');
    ASSERT_EQ(words.size(), others.size()) << pair->text;
    int differ = 0;
    for (std::size_t i = 0; i < words.size(); ++i) differ += words[i] == others[i] ? 0 : 1;
    EXPECT_EQ(differ, 1) << pair->text;
    auto other = task;
    other.goal = pair->goal;
    EXPECT_TRUE(check_instruction(pair->text, other, knowledge, nouns, &home).empty()) << pair->text;
    EXPECT_FALSE(check_instruction(pair->text, task, knowledge, nouns, &home).empty()) << pair->text;
    EXPECT_FALSE(check_instruction(text, other, knowledge, nouns, &home).empty()) << pair->text;
  }
  EXPECT_GE(found, 15);
}

TEST(MinimalPair, NamesThingsOfTheSameKindBeforeOthers) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const NounTable nouns(knowledge, committed_names());
  const Scene home = kitchen_with({"Fork", "Spoon", "Book", "Vase", "Apple"});
  const auto task = asking("(exists (?m - Fork) (at-end (held ?m)))");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto pair = minimal_pair("Pick up the fork.", task, knowledge, nouns, home, Rng(seed));
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->text, "Pick up the spoon.");
  }
}

TEST(MinimalPair, KeepsCapitalsToTheFirstWord) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const NounTable nouns(knowledge, committed_names());
  const Scene home = kitchen_with({"CD", "Book"});
  const auto task = asking("(exists (?m - CD) (at-end (held ?m)))");
  const auto pair = minimal_pair("Pick up the CD.", task, knowledge, nouns, home, Rng(1));
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->text, "Pick up the book.");
}

TEST(MinimalPair, IsNoneWhereNoOtherWordSaysAnything) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const NounTable nouns(knowledge, committed_names());
  const Scene home = kitchen_with({"Mug"});
  const auto task = asking("(exists (?m - Mug) (at-end (held ?m)))");
  EXPECT_FALSE(minimal_pair("Pick up the mug.", task, knowledge, nouns, home, Rng(1)));
}

}  // namespace
}  // namespace unietp
