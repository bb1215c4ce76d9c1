// What "it" means: what was named last, and nothing that was named before that.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "annotator/noun_table.h"
#include "core/text.h"
#include "small_knowledge.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using testing_support::asking;
using testing_support::small_knowledge;

constexpr const char* kWashAndPut = "(exists (?m - Mug) (exists (?t - Table) (at-end (and (clean ?m) (on ?m ?t)))))";

bool says(const std::string& text, const char* goal) {
  return check_instruction(text, asking(goal), small_knowledge()).empty();
}

TEST(Pronouns, MeanWhatWasNamedLast) {
  EXPECT_TRUE(says("Wash the mug and put it on the table.", kWashAndPut));
  EXPECT_TRUE(says("Put the mug on the table and wash the mug.", kWashAndPut));
  EXPECT_FALSE(says("Put the mug on the table. Wash it.", kWashAndPut));
  EXPECT_FALSE(says("Put the mug on the table and wash it.", kWashAndPut));
}

TEST(Pronouns, OfAPlaceAreNotWhatIsPutThere) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const auto faults = [&](const char* text, const char* goal) {
    return join(check_instruction(text, asking(goal), knowledge), "; ");
  };
  const char* filled = "(exists (?e - Egg) (exists (?f - Fridge) (at-end (and (inside ?e ?f) (open ?f)))))";
  EXPECT_EQ(faults("Open the fridge and put the egg in it.", filled), "");
  const char* also =
      "(exists (?a - Apple) (exists (?e - Egg) (exists (?f - Fridge) (at-end (and (inside ?e ?f) (open ?f) (cool "
      "?a))))))";
  EXPECT_EQ(faults("Open the fridge, chill the apple, and put the egg in the fridge.", also), "");
  EXPECT_NE(faults("Open the fridge, chill the apple, and put the egg in it.", also), "");
}

TEST(Pronouns, MeanNothingWhereSomethingElseWasNamedThatHasNoName) {
  EXPECT_FALSE(says("Put a mug on any table. Wash it.",
                    "(exists (?m - Mug) (at-end (and (clean ?m) (exists (?t - Table) (on ?m ?t)))))"));
}

TEST(Pronouns, MeanWhatASentenceOfTheHomeIsAbout) {
  const char* on = "(exists (?m - (Mug :where (exists (?t - Table) (on ?m ?t)))) (at-end (clean ?m)))";
  const char* beside = "(exists (?m - (Mug :where (exists (?b - Bowl) (next_to ?m ?b)))) (at-end (clean ?m)))";
  EXPECT_FALSE(says("There is a mug next to the bowl. Wash it.", beside));
  EXPECT_TRUE(says("Wash the mug that is next to the bowl.", beside));
  EXPECT_TRUE(says("Wash the mug that is on the table.", on));
}

/// Of a goal about a mug that goes on a table, each "it" comes where the mug was named last.
TEST(Pronouns, AreWrittenOnlyForWhatWasNamedLast) {
  const Knowledge knowledge = small_knowledge();
  const NounTable nouns(knowledge, committed_names());
  int pronouns = 0;
  for (const Phrasings phrasings : {Phrasings::Everyday, Phrasings::All}) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const auto written =
          write_instruction(asking(kWashAndPut), knowledge, nouns, {phrasings, {}, nullptr}, Rng(seed));
      ASSERT_TRUE(written) << format(written.error());
      std::string last;
      for (const Token& token : tokens_of(written->text)) {
        if (token.text == "mug" || token.text == "table") last = token.text;
        if (token.text != "it") continue;
        if (last.empty()) continue;  // "see to it that"
        EXPECT_EQ(last, "mug") << written->text;
        ++pronouns;
      }
    }
  }
  EXPECT_GT(pronouns, 60);
}

TEST(Pronouns, MeanWhatTheLastCommandWasAboutWhereTheOtherCannotBeMeant) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  const auto faults = [&](const char* text, const char* goal) {
    return join(check_instruction(text, asking(goal), knowledge), "; ");
  };
  const char* lit = "(exists (?l - DeskLamp) (exists (?d - Desk) (at-end (and (on ?l ?d) (power_on ?l)))))";
  EXPECT_EQ(faults("Put the desk lamp on the desk and turn it on.", lit), "");
  const char* other =
      "(exists (?l - DeskLamp) (exists (?m - Laptop) (exists (?d - Desk) (at-end (and (on ?l ?d) (open ?m) (power_on "
      "?l))))))";
  EXPECT_NE(faults("Put the desk lamp on the desk, open the laptop and turn it on.", other), "");
}

/// What people say, and the grammar reads: what is put somewhere is to be washed or filled first.
TEST(Results, OfWhatIsPutSomewhereAreReadInItsName) {
  EXPECT_TRUE(says("Put a washed mug on the table.", kWashAndPut));
  EXPECT_TRUE(
      says("Put a bowl with a heated apple in it on the table.",
           "(exists (?a - Apple) (exists (?b - Bowl) (exists (?t - Table) (at-end (and (hot ?a) (inside ?a ?b) (on ?b "
           "?t))))))"));
}

/// A stranger takes "a washed mug" for one that is clean already.
TEST(Results, AreWrittenAsCommandsOfTheirOwn) {
  const Knowledge knowledge = small_knowledge();
  const NounTable nouns(knowledge, committed_names());
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const auto written = write_instruction(asking(kWashAndPut), knowledge, nouns, {}, Rng(seed));
    ASSERT_TRUE(written) << format(written.error());
    EXPECT_THAT(written->text, ::testing::Not(::testing::HasSubstr("washed")));
  }
}

TEST(Results, AreAskedForAndNotTakenForWhatIsSo) {
  const char* place = "(exists (?m - Mug) (exists (?t - Table) (at-end (on ?m ?t))))";
  EXPECT_FALSE(says("Put a washed mug on the table.", place));
  EXPECT_FALSE(says("Put a bowl with an apple in it on the table.",
                    "(exists (?b - Bowl) (exists (?t - Table) (at-end (on ?b ?t))))"));
  EXPECT_FALSE(says("Put a heated mug on the table.", kWashAndPut));
}

}  // namespace
}  // namespace unietp
