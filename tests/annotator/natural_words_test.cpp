// What a native speaker would stumble over, or read otherwise than it is meant.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "annotator/meaning.h"
#include "annotator/noun_table.h"
#include "annotator/other_wordings.h"
#include "annotator/sounds_right.h"
#include "core/text.h"
#include "small_knowledge.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using testing_support::asking;
using testing_support::small_knowledge;

/// Many texts of a goal, each of which reads back as it.
std::vector<std::string> texts_of(const std::string& goal, const std::string& style = "direct",
                                  const std::string& start = "") {
  static const Knowledge knowledge = small_knowledge();
  static const NounTable nouns(knowledge, committed_names());
  auto specification = asking(goal, style);
  if (!start.empty()) specification.init = {*parse_formula("test", start, FormulaUse::State)};
  std::vector<std::string> texts;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto written = write_instruction(specification, knowledge, nouns, {Phrasings::All, {}, nullptr}, Rng(seed));
    EXPECT_TRUE(written) << format(written.error());
    if (!written) break;
    EXPECT_EQ(name_of(written->style), style) << written->text;
    texts.push_back(written->text);
  }
  return texts;
}

TEST(NaturalWords, ForbidWithMayAndNotWithHasTo) {
  const auto none = texts_of("(at-end (forall (?c - Table) (forall (?y - Mug) (not (on ?y ?c)))))");
  EXPECT_THAT(none, Contains(AnyOf(HasSubstr("no mug may be"), HasSubstr("no mugs may be"))));
  EXPECT_THAT(none, Each(Not(AnyOf(HasSubstr("has to be"), HasSubstr("have to be"), HasSubstr("must be")))));
  const auto few = texts_of("(exists (?b - Table) (at-end (count <= 1 (?a - Mug) (on ?a ?b))))");
  EXPECT_THAT(few, Contains(HasSubstr("may be on")));
}

TEST(NaturalWords, DenyWithTheVerb) {
  const auto texts = texts_of("(exists (?a - Mug) (at-end (not (covered ?a dust))))");
  EXPECT_THAT(texts, Contains(HasSubstr("must not be covered with dust")));
  EXPECT_THAT(texts, Each(Not(HasSubstr("be not"))));
}

TEST(NaturalWords, ChooseOneOfSeveralRooms) {
  const auto texts = texts_of("(exists (?r - kitchen) (at-end (count = 0 (?a - Mug) (on_floor ?a ?r))))");
  EXPECT_THAT(texts, Contains(AnyOf(HasSubstr("Choose a kitchen."), HasSubstr("Choose one kitchen."))));
  EXPECT_THAT(texts, Contains(HasSubstr("on its floor")));
  EXPECT_THAT(texts, Each(Not(AnyOf(HasSubstr("Choose the"), HasSubstr("floor of it")))));
}

TEST(NaturalWords, NameAThingByItsUseAgainWhereThatObjectCouldBeAnother) {
  const auto texts = texts_of(
      "(exists (?k - Knife) (exists (?a - (either Bowl Mug)) (exists (?b - Table) (at-end (and (inside ?k ?a) "
      "(on ?a ?b))))))",
      "function");
  EXPECT_THAT(texts, Contains(HasSubstr("that thing to drink from")));
  EXPECT_THAT(texts, Each(Not(HasSubstr("object"))));
}

TEST(NaturalWords, TakeAThingBeforeItsUseMeetsAPlace) {
  const auto texts =
      texts_of("(exists (?a - (either Bowl Mug)) (exists (?b - Table) (at-end (on ?a ?b))))", "function");
  EXPECT_THAT(texts, Contains(HasSubstr("ake something to drink from and put it on")));
  EXPECT_THAT(texts, Each(Not(HasSubstr("drink from on"))));
}

TEST(NaturalWords, BringToARoomWhatIsSought) {
  const Knowledge knowledge = small_knowledge();
  const NounTable nouns(knowledge, committed_names());
  const auto task =
      asking("(exists (?a - (either Bowl Mug)) (exists (?r - kitchen) (at-end (in_room ?a ?r))))", "function");
  EXPECT_TRUE(check_instruction("Get something to drink from and bring it to the kitchen.", task, knowledge).empty());
  EXPECT_FALSE(check_instruction("Get something to drink from and bring it to the office.", task, knowledge).empty());
  EXPECT_FALSE(check_instruction("Get something to drink from and bring it.", task, knowledge).empty());
  std::vector<std::string> texts;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto written = write_instruction(task, knowledge, nouns, {}, Rng(seed));
    ASSERT_TRUE(written) << format(written.error());
    texts.push_back(written->text);
  }
  EXPECT_THAT(texts, Contains(HasSubstr("et something to drink from and bring it to a kitchen")));
  EXPECT_THAT(texts, Each(Not(HasSubstr("put it in"))));
}

Scene home_with(const std::vector<std::string>& categories) {
  Scene home;
  for (const std::string& category : categories) {
    Node node;
    node.id = lower(category) + "_1";
    node.category = category;
    home.nodes.push_back(node);
  }
  return home;
}

/// Texts of a goal of AI2-THOR as people ask for it, in a home that has one thing of each category.
std::vector<std::string> everyday_texts(const std::string& goal, const std::vector<std::string>& categories,
                                        const std::vector<std::string>& phrasings = {}) {
  static const NounTable nouns(committed_knowledge(Simulator::Ai2thor), committed_names());
  const Scene home = home_with(categories);
  WritingOptions options;
  options.home = &home;
  options.tells_apart = true;
  options.phrasings_of_template = phrasings;
  std::vector<std::string> texts;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto written = write_instruction(asking(goal, phrasings.empty() ? "direct" : "implicit-need"),
                                           committed_knowledge(Simulator::Ai2thor), nouns, options, Rng(seed));
    if (written) texts.push_back(written->text);
  }
  return texts;
}

TEST(NaturalWords, PutThingsAwayWhereThingsAreKept) {
  const auto texts = everyday_texts("(exists (?a - Plate) (exists (?b - Cabinet) (at-end (inside ?a ?b))))",
                                    {"Plate", "Cabinet", "Fridge"});
  EXPECT_THAT(texts, Contains("Put the plate away in the cabinet."));
  EXPECT_THAT(texts, Contains("Put the plate in the cabinet."));
  EXPECT_THAT(everyday_texts("(exists (?a - Plate) (exists (?b - Fridge) (at-end (inside ?a ?b))))",
                             {"Plate", "Cabinet", "Fridge"}),
              Each(Not(HasSubstr("away"))));
  const auto task = asking("(exists (?a - Plate) (exists (?b - DiningTable) (at-end (on ?a ?b))))");
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  EXPECT_TRUE(check_instruction("Put a plate on a dining table.", task, knowledge).empty());
  EXPECT_FALSE(check_instruction("Put a plate away on a dining table.", task, knowledge).empty());
}

TEST(NaturalWords, AreThoseThatSoundRight) {
  const auto sound = [](const std::string& right, const std::string& wrong) {
    EXPECT_TRUE(sounds_right(right)) << right;
    EXPECT_FALSE(sounds_right(wrong)) << wrong;
  };
  sound("Put both pieces of bread on the table.", "Put both pieces of juice on the table.");
  sound("Put a couple of mugs in the wardrobe.", "Put a couple of baby shoes in the wardrobe.");
  sound("Put a couple of shirts in the box next to the shoes.", "Put a couple of gloves on the bed.");
  sound("Close the brown chest of drawers.", "Open up the brown chest of drawers.");
  sound("Open the box on the chest of drawers.", "Shut the box, then open the chest of drawers.");
  sound("Put enough forks on the table, one for each plate there.",
        "Put enough forks on the table, one for each platter there.");
}

TEST(NaturalWords, AskBehindASentence) {
  const Knowledge& knowledge = committed_knowledge(Simulator::Ai2thor);
  static const NounTable nouns(knowledge, committed_names());
  Instruction command;
  command.text = "I want to make a stew. Get something to make it in and put it on the counter.";
  const auto requests =
      requests_for(command, asking("(exists (?a - Pot) (exists (?b - CounterTop) (at-end (on ?a ?b))))"), knowledge,
                   nouns, home_with({"Pot", "CounterTop"}), {}, 9);
  std::vector<std::string> texts;
  for (const Instruction& request : requests) texts.push_back(request.text);
  EXPECT_THAT(texts,
              Contains("I want to make a stew. Could you get something to make it in and put it on the counter?"));
  EXPECT_THAT(texts, Each(testing::StartsWith("I want to make a stew. ")));
}

TEST(NaturalWords, CountNothingThatIsNotCounted) {
  const auto texts_with = [](const std::string& food) {
    return everyday_texts("(exists (?a - " + food + ") (exists (?b - Plate) (at-end (and (hot ?a) (on ?a ?b)))))",
                          {food, "Plate"}, {"I'd like a warm {A}. Put it {B:on}."});
  };
  EXPECT_THAT(texts_with("Potato"), Contains("I'd like a warm potato. Put it on the plate."));
  EXPECT_THAT(texts_with("Bread"), Each(Not(HasSubstr("a warm bread"))));
}

TEST(NaturalWords, NameNothingThatAnotherThingOfTheHomeMayBeCalled) {
  const std::string goal = "(exists (?a - Plate) (exists (?b - Drawer) (at-end (inside ?a ?b))))";
  EXPECT_THAT(everyday_texts(goal, {"Plate", "Drawer"}), Contains(HasSubstr("the drawer")));
  EXPECT_THAT(everyday_texts(goal, {"Plate", "Drawer", "Dresser"}), ::testing::IsEmpty());
}

TEST(NaturalWords, SayLastWhatAThingIsNeededFor) {
  const auto texts = texts_of(
      "(exists (?a - (either Bowl Mug)) (exists (?k - Knife) (at-end (and (held ?k) (clean ?a)))))", "function");
  EXPECT_THAT(texts, Contains(HasSubstr("something to drink from")));
  EXPECT_THAT(texts, Each(Not(AnyOf(HasSubstr("drink from and a"), HasSubstr("drink from and the")))));
}

TEST(NaturalWords, TieToAnyOfAKindThatIsSpokenOf) {
  const auto texts =
      texts_of("(exists (?a - Mug) (at-end (clean ?a)))", "condition", "(count >= 1 (?m - Mug) (dirty ?m))");
  EXPECT_THAT(texts, Each(HasSubstr("If any mug is dirty, ")));
}

TEST(NaturalWords, CloseAfterWhatIsTakenOut) {
  const auto texts = texts_of(
      "(exists (?b - Fridge) (and (sometime (open ?b)) (at-end (and (closed ?b) (count = 0 (?a - Mug) (inside ?a "
      "?b))))))");
  for (const std::string& text : texts) {
    EXPECT_THAT(text, Not(HasSubstr("again")));
    const auto closed = std::min({text.find("close"), text.find("Close"), text.find("shut"), text.find("Shut")});
    EXPECT_GT(closed, text.find("mug")) << text;
  }
}

TEST(NaturalWords, SayNowOfWhatWillChangeAndOfNothingElse) {
  const auto placed = texts_of(
      "(exists (?a - (Mug :where (exists (?b - Table) (on ?a ?b)))) (exists (?c - Fridge) (at-end (inside ?a ?c))))");
  EXPECT_THAT(placed, Contains(HasSubstr("that is now on a table")));
  EXPECT_THAT(placed, Each(Not(AnyOf(HasSubstr("that is on a table is"), HasSubstr("that is on a table should be")))));
  EXPECT_THAT(texts_of("(exists (?a - (Mug :where (colour ?a red))) (at-end (clean ?a)))"),
              Each(Not(HasSubstr("now"))));
}

TEST(NaturalWords, DescribeByAPlaceOnlyWhereItIsNotThePlaceOfTheWork) {
  const auto texts = texts_of("(exists (?a - (Apple :where (exists (?b - Table) (on ?a ?b)))) (at-end (cooked ?a)))");
  EXPECT_THAT(texts, Each(Not(HasSubstr("apple on"))));
}

TEST(NaturalWords, DoNotSayThatTwice) {
  EXPECT_THAT(texts_of("(exists (?a - Bread) (exists (?b - Table) (at-end (and (cooked ?a) (on ?a ?b)))))"),
              Each(Not(HasSubstr("that that"))));
}

TEST(ReadInstruction, TakesMayOnlyForWhatIsForbidden) {
  const auto read = [](const char* text) { return parse_instruction(text, small_knowledge()); };
  const auto none =
      parse_formula("test", "(at-end (forall (?c - Table) (forall (?y - Mug) (not (on ?y ?c)))))", FormulaUse::Goal);
  const auto text = read("At the end, no mug may be on any table.");
  ASSERT_TRUE(text) << format(text.error());
  EXPECT_TRUE(same_meaning(*text, *none));
  EXPECT_FALSE(read("At the end, a mug may be on a table."));
  EXPECT_FALSE(read("At the end, a mug must not be hot and dirty."));
}

TEST(FunctionStyle, IsNotClaimedForAPhraseThatFitsAnotherThing) {
  // Mugs are something to drink from, too: of cups alone it would ask for less than the goal.
  const std::string phrase = "something to drink from";
  const auto& tables = committed_knowledge(Simulator::Behavior);
  const NounTable nouns(tables, committed_names());
  const auto said = [&](const std::string& things) {
    const auto task = asking("(exists (?a - " + things + ") (at-end (held ?a)))", "function");
    std::string texts;
    for (std::uint64_t seed = 0; seed < 50; ++seed)
      if (const auto text = write_instruction(task, tables, nouns, {}, Rng(seed))) texts += text->text + "\n";
    return texts;
  };
  EXPECT_THAT(said("coffee_cup"), Not(HasSubstr(phrase)));
  const auto served = nouns.phrases().find(phrase);
  ASSERT_NE(served, nouns.phrases().end());
  EXPECT_THAT(said(to_text(served->second.noun)), HasSubstr(phrase));
}

}  // namespace
}  // namespace unietp
