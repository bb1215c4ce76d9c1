#include "annotator/word_check.h"

#include "annotator/opposite_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "small_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::asking;
using testing_support::small_knowledge;

constexpr const char* kTwoMugs = "(exists (?b - Table) (at-end (count = 2 (?a - Mug) (on ?a ?b))))";
constexpr const char* kOrder =
    "(exists (?a - Mug) (exists (?b - Fridge) (and (before (clean ?a) (inside ?a ?b)) (at-end (inside ?a ?b)))))";

std::vector<std::string> said(const char* goal, const char* text) {
  static const NounTable nouns(small_knowledge(), committed_names());
  return saying_faults(text, asking(goal), nouns);
}

TEST(FormFaults, AreIdsCoordinatesTemplatesMarkupAndOtherLanguages) {
  auto specification = asking(kTwoMugs);
  specification.template_name = "put-two-on";
  for (const char* text : {"Put mug_3 on the table.", "Put mug3 on the table.", "Put mug-12 on the table.",
                           "Put a mug at 1.25, 3.5.", "**Put** two mugs on the table.", "Do put-two-on with mugs.",
                           "Put ?a on the table (on ?a ?b) [1].", "Stelle genau zwei Becher auf den Tisch.",
                           "Pon dos tazas sobre la mesa grande ahora.", "Put the caf\xc3\xa9 cup.", "", "Mugs."})
    EXPECT_FALSE(form_faults(text, specification).empty()) << text;
  EXPECT_TRUE(form_faults("Put exactly two mugs on a table.", specification).empty());
  EXPECT_FALSE(form_faults(std::string(2000, 'a') + std::string(400, ' '), specification).empty() &&
               form_faults(
                   [] {
                     std::string many;
                     for (int i = 0; i < 200; ++i) many += "put a mug ";
                     return many;
                   }(),
                   specification)
                   .empty());
}

TEST(SayingFaults, AreWhatTheTextLacks) {
  EXPECT_TRUE(said(kTwoMugs, "Exactly two mugs have to stand on one table.").empty());
  EXPECT_FALSE(said(kTwoMugs, "Put some mugs on one table, exactly that.").empty());  // the number
  EXPECT_TRUE(said(kTwoMugs, "Put two mugs on one table.").empty());
  EXPECT_FALSE(said(kTwoMugs, "Put at least two mugs on one table.").empty());         // that it is exact
  EXPECT_FALSE(said(kTwoMugs, "Put a couple of mugs on one table.").empty());          // that it is exact
  EXPECT_FALSE(said(kTwoMugs, "Put exactly two of them on one table.").empty());       // of what
  EXPECT_FALSE(said(kOrder, "Put a clean mug in the fridge.").empty());                // the order
  EXPECT_FALSE(said(kOrder, "First take a mug, then put it in the fridge.").empty());  // the state
  EXPECT_TRUE(said(kOrder, "Rinse a mug, and only after that store it in the fridge.").empty());
}

TEST(SayingFaults, AreWhatTheTextHasTooMuch) {
  EXPECT_FALSE(said(kTwoMugs, "Put exactly two mugs and a bowl on one table.").empty());
  EXPECT_FALSE(said(kTwoMugs, "Wash exactly two mugs and put them on one table.").empty());
  EXPECT_FALSE(said(kTwoMugs, "Put exactly two red mugs on one table.").empty());
  EXPECT_FALSE(said(kTwoMugs, "Put exactly two mugs on one of the four tables.").empty());
  EXPECT_FALSE(said(kTwoMugs, "Keep exactly two mugs on one table the whole time.").empty());
  EXPECT_FALSE(said(kTwoMugs, "First find exactly two mugs, then put them on every table.").empty());
}

/// A model's text in which one word has another meaning: no such word may pass unseen.
TEST(SayingFaults, AreWordsThatNothingExplains) {
  constexpr const char* kOn = "(exists (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))";
  EXPECT_TRUE(said(kOn, "Could you please find a mug and put it on a table for me?").empty());
  EXPECT_TRUE(said(kOn, "I'd like you to bring a mug over to a table and leave it standing on top.").empty());
  for (const char* text : {"Could you please find a mug and throw it on a table for me?",
                           "Please find a mug and glue it on a table.",
                           "Please hide a mug and put it on a table.",
                           "Please paint a mug and put it on a table.",
                           "Please find a mug and do not put it on a table.",
                           "Never find a mug or put it on a table.",
                           "Please find a mug without putting it on a table.",
                           "Please find a mug and put it behind, not on, a table.",
                           "Please find a heavy mug and put it on a table.",
                           "Please find a mug and put it on a table tomorrow.",
                           "Please find a mug and put it upside on a table.",
                           "Please find a mug and balance it on a table.",
                           "Please find my neighbor's mug and put it on a table.",
                           "Please buy a mug and put it on a table.",
                           "Please find a mug and drag it on a table.",
                           "Please measure a mug and put it on a table.",
                           "Please find a mug and put it on a wobbly table.",
                           "Please find a mug and photograph it on a table.",
                           "Please find a mug and put it on a table alone.",
                           "Please find a mug and spin it on a table."})
    EXPECT_FALSE(said(kOn, text).empty()) << text;
}

TEST(SayingFaults, AreSlipsOfThePen) {
  constexpr const char* kFridge = "(exists (?b - Fridge) (at-end (open ?b)))";
  EXPECT_TRUE(said(kFridge, "Open a fridge.").empty());
  EXPECT_THAT(said(kFridge, "Open a frigde."), Contains(HasSubstr("'frigde' looks like a slip for 'fridge'")));
  EXPECT_THAT(said(kFridge, "As soon as you can reach over the ridge, open a fridge."),
              Each(Not(HasSubstr("slip"))));  // a word of its own
}

TEST(SayingFaults, AreNotInAVerbThatIsAlsoAName) {
  auto tables = small_knowledge().categories();
  tables.push_back(tables.front());
  tables.back().name = "Switch", tables.back().display = "switch", tables.back().plural = "switches";
  const NounTable nouns(Knowledge(Simulator::Ai2thor, tables, {}, {}, {}, {}), committed_names());
  EXPECT_TRUE(saying_faults("Switch a lamp on.", asking("(exists (?a - Lamp) (at-end (power_on ?a)))"), nouns).empty());
  EXPECT_FALSE(
      saying_faults("Wash a mug and a switch.", asking("(exists (?a - Mug) (at-end (clean ?a)))"), nouns).empty());
}

TEST(SayingFaults, AreNotInWhatIsAskedForNothing) {
  constexpr const char* kFridge = "(exists (?b - Fridge) (at-end (open ?b)))";
  static const NounTable nouns(small_knowledge(), committed_names());
  EXPECT_TRUE(saying_faults("There is a mug on the table. Open a fridge.", asking(kFridge, "aside"), nouns).empty());
  EXPECT_FALSE(saying_faults("There is a mug on the table. Open a fridge.", asking(kFridge), nouns).empty());
}

constexpr const char* kOn = "(exists (?a - Lamp) (at-end (power_on ?a)))";
constexpr const char* kOff = "(exists (?a - (Lamp :where (exists (?t - Table) (on ?a ?t)))) (at-end (power_off ?a)))";
constexpr const char* kAllOnTable = "(exists (?b - Table) (forall (?a - Mug) (at-end (on ?a ?b))))";
constexpr const char* kOneOnTable = "(exists (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))";
constexpr const char* kAtLeastTwo = "(exists (?b - Table) (at-end (count >= 2 (?a - Mug) (on ?a ?b))))";
constexpr const char* kAtMostTwo = "(exists (?b - Table) (at-end (count <= 2 (?a - Mug) (on ?a ?b))))";
constexpr const char* kLarge = "(exists (?a - (Mug :where (size ?a large))) (at-end (clean ?a)))";
constexpr const char* kEither =
    "(exists (?b - Table) (at-end (or (exists (?a - Mug) (on ?a ?b)) (exists (?c - Bowl) (on ?c ?b)))))";
constexpr const char* kCleanFirst =
    "(exists (?b - Table) (exists (?a - Mug) (and (before (clean ?b) (on ?a ?b)) (at-end (on ?a ?b)))))";
constexpr const char* kTaken =
    "(exists (?a - (Mug :where (exists (?t - Table) (on ?a ?t)))) (exists (?b - Fridge) (at-end (inside ?a ?b))))";
constexpr const char* kApart =
    "(exists (?b - Table) (exists (?c - Fridge) (at-end (and (forall (?a - Mug) (or (on ?a ?b) (inside ?a ?c))) "
    "(exists (?d - Mug) (on ?d ?b)) (exists (?e - Mug) (inside ?e ?c))))))";

TEST(OppositeFaults, AreNoWordsThatSayAnotherThing) {
  for (const auto& [goal, text] : std::initializer_list<std::pair<const char*, const char*>>{
           {"(exists (?a - Lamp) (at-end (power_on ?a)))", "Take the mug out and turn on the lamp."},
           {"(exists (?a - Lamp) (at-end (power_on ?a)))", "Put the mug down, then turn on the lamp."},
           {"(exists (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))",
            "Put the mug made out of clay on the table."},
           {kAtLeastTwo, "Put at least two mugs on the table; which ones is up to you."}}) {
    const auto faults = opposite_faults(tokens_of(text), asking(goal));
    EXPECT_TRUE(faults.empty()) << text << ": " << faults.front();
  }
  EXPECT_FALSE(opposite_faults(tokens_of("Put up to two mugs on the table."), asking(kAtLeastTwo)).empty());
}

TEST(OppositeFaults, AreWordsThatTurnTheMeaningAround) {
  const struct {
    const char *goal, *right, *wrong;
  } cases[] = {
      {kOn, "Turn on the lamp.", "Turn off the lamp."},
      {kOn, "Please switch the lamp on.", "Please switch the lamp off."},
      {kOn, "I'd like the lamp turned on.", "I'd like the lamp turned off."},
      {kOff, "Turn off the lamp on the table.", "Turn on the lamp on the table."},
      {kOff, "Turn the lamp on the table off.", "Turn the lamp on the table on."},
      {kOff, "Switch the lamp that's on the table off, please.", "Leave the lamp on the table switched on."},
      {kAllOnTable, "Put both mugs on the table.", "Put none of the mugs on the table."},
      {kAllOnTable, "Put all the mugs on the table.", "Put neither of the mugs on the table; no mugs, not all."},
      {kAllOnTable, "Put every mug on the table.", "Don't put every mug on the table."},
      {kApart, "Put one of the mugs on the table and the other one in the fridge.",
       "Put all the mugs on the table and the other one in the fridge."},
      {kTwoMugs, "Put two mugs on a table.", "Put no mugs, neither of the two, on a table."},
      {kOneOnTable, "Put a mug on the table.", "Put all the mugs on the table."},
      {kOneOnTable, "Put a mug on the table.", "Take a mug off the table."},
      {kOneOnTable, "Put a mug on the table.", "Take a mug out of the table."},
      {kTaken, "Take a mug off the table and put it in the fridge.", "Last, put the mug on the table in the fridge."},
      {kAtLeastTwo, "Put at least two mugs on a table.", "Put at most two mugs on a table."},
      {kAtLeastTwo, "Put no fewer than two mugs on a table.", "Put no more than two mugs on a table."},
      {kAtMostTwo, "Put at most two mugs on a table.", "Put at least two mugs on a table, no more than that."},
      {kLarge, "Wash the larger mug.", "Wash the smaller mug."},
      {kEither, "Put a mug or a bowl on a table.", "Put a mug and a bowl on a table."},
      {kOneOnTable, "Put a mug on the table.", "Put a mug on or on the table."},
      {kCleanFirst, "First clean the table, then put a mug on it.", "Last clean the table, then put a mug on it."},
      {kCleanFirst, "Clean the table before putting a mug on it.", "Clean the table after putting a mug on it."},
      {kCleanFirst, "Before you put a mug on the table, clean it.", "Before you clean the table, put a mug on it."},
      {kCleanFirst, "Put a mug on the table, but first clean it.", "Clean the table, but first put a mug on it."},
      {kCleanFirst, "Put a mug on the table, but clean it first.", "Put a mug on the table, but clean it last."},
      {kCleanFirst, "Clean the table first, then put a mug on it.", "Put a mug on the table and clean it last."},
      {kCleanFirst, "Once the table is clean, put a mug on it.", "Put a mug on the table, then clean it."},
      {kCleanFirst, "Clean the table. After that, put a mug on it.", "Put a mug on the table. After that, clean it."},
  };
  for (const auto& one : cases) {
    EXPECT_THAT(said(one.goal, one.right), ::testing::IsEmpty()) << one.right;
    EXPECT_THAT(said(one.goal, one.wrong), Not(::testing::IsEmpty())) << one.wrong;
  }
}

}  // namespace
}  // namespace unietp
