#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "annotator/home_reading.h"
#include "annotator/home_sentences.h"
#include "annotator/instruction.h"
#include "annotator/meaning.h"
#include "annotator/parse.h"
#include "core/text.h"
#include "small_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using testing_support::asking;
using testing_support::small_knowledge;

/// With what can be done to mugs and fridges.
Knowledge knowledge_of_mugs() {
  const auto small = small_knowledge();
  std::vector<AffordanceFact> facts;
  for (const char* category : {"Fridge", "Lamp", "Mug"})
    for (const char* affordance : {"dirtyable", "fillable", "openable", "pickupable", "switchable"})
      facts.push_back({category, affordance, {"curated", 1}});
  return Knowledge(small.simulator(), small.categories(), facts, {}, {}, small.aliases());
}

/// A lamp and two mugs, of which the first is dirty and stands on the table, and a fridge.
Trace home() {
  Trace start;
  const auto object = [](const char* id, const char* category) {
    return Entity{Entity::Kind::Object, id, category, ""};
  };
  start.entities = EntityList{Entity{Entity::Kind::Agent, "agent", "", ""},
                              object("mug_1", "Mug"),
                              object("mug_2", "Mug"),
                              object("table_1", "Table"),
                              object("fridge_1", "Fridge"),
                              object("lamp_1", "Lamp")};
  Facts facts;
  for (std::uint32_t i = 0; i < 6; ++i) facts.set_exists(EntityIndex(i));
  facts.set(Predicate::Dirty, EntityIndex(1));
  facts.set(Predicate::Clean, EntityIndex(2));
  facts.set(Predicate::Closed, EntityIndex(4));
  facts.set(Predicate::On, EntityIndex(1), EntityIndex(3));
  start.states = {facts};
  return start;
}

std::vector<Reading> read(const std::string& text) {
  const auto knowledge = knowledge_of_mugs();
  auto readings = readings_of(text, NounTable(knowledge, committed_names()));
  EXPECT_TRUE(readings) << format(readings.error());
  if (!readings) return {};
  const Trace start = home();
  return readings_in_home(std::move(*readings), knowledge, &start);
}

void expect_goal(const std::string& text, const std::string& goal) {
  const auto readings = read(text);
  ASSERT_THAT(readings, SizeIs(1)) << text;
  const auto wanted = parse_formula("test", goal, FormulaUse::Goal);
  ASSERT_TRUE(wanted) << format(wanted.error());
  EXPECT_TRUE(same_meaning(readings[0].goal, *wanted)) << text << "\n" << to_text(readings[0].goal);
}

TEST(Phenomena, AnaphoraSpeaksOfWhatTheFirstSentenceNamed) {
  expect_goal("There is a mug on the table. Pick it up.",
              "(exists (?a - (Mug :where (exists (?t - Table) (on ?a ?t)))) (at-end (held ?a)))");
  expect_goal("There is a dirty mug somewhere. Wash that mug.",
              "(exists (?a - (Mug :where (dirty ?a))) (at-end (clean ?a)))");
}

TEST(Phenomena, WhatIsOnlyMentionedIsNotAskedFor) {
  expect_goal("The fridge is closed. There is a mug on the table. Turn on a lamp.",
              "(exists (?a - Lamp) (at-end (power_on ?a)))");
}

TEST(Phenomena, WhatIsNotSoInTheHomeIsNoReading) {
  EXPECT_THAT(read("The fridge is open. Wash the dirty mug."), IsEmpty());
  EXPECT_THAT(read("There is a dirty fridge somewhere. Wash it."), IsEmpty());
  EXPECT_THAT(read("There is more than one table here. Wash the dirty mug."), IsEmpty());
  EXPECT_THAT(read("The mug is dirty. Wash the dirty mug."), IsEmpty());  // which one?
}

TEST(Phenomena, ItHasAReadingForEachThingThatWasNamed) {
  EXPECT_THAT(read("There is a mug on the table. Open a fridge and wash it."), SizeIs(2));
}

TEST(Phenomena, OfAnAlternativeOnePartIsThere) {
  expect_goal(
      "If the fridge is open, put a mug in it. If not, put it on a table.",
      "(or (exists (?f - (Fridge :where (open ?f))) (exists (?a - Mug) (at-end (inside ?a ?f)))) "
      "(exists (?f - (Fridge :where (closed ?f))) (exists (?a - Mug) (exists (?t - Table) (at-end (on ?a ?t))))))");
  EXPECT_THAT(read("If the table is open, put a mug in it. If not, put it on a fridge."), IsEmpty());
}

TEST(Phenomena, EllipsisTakesTheNounOfWhatWasNamed) {
  expect_goal("There is more than one mug here. Wash the dirty one.",
              "(exists (?a - (Mug :where (dirty ?a))) (at-end (clean ?a)))");
  EXPECT_FALSE(readings_of("Wash the dirty one.", NounTable(small_knowledge(), committed_names())));
}

TEST(Phenomena, AContrastTellsWhichOneIsMeant) {
  expect_goal("Pick up the dirty mug, not the clean one.",
              "(exists (?a - (Mug :where (dirty ?a))) (at-end (held ?a)))");
  EXPECT_THAT(read("Pick up the dirty mug, not the hot one."), IsEmpty());  // there is none
}

TEST(Phenomena, ASubordinateClauseSaysWhatComesFirst) {
  const auto read = parse_with("Once you've put a mug on a table, switch a lamp on.",
                               NounTable(small_knowledge(), committed_names()));
  ASSERT_TRUE(read) << format(read.error());
  const auto wanted = parse_formula(
      "test",
      "(exists (?a - Mug) (exists (?b - Table) (exists (?c - Lamp) (and (before (on ?a ?b) (power_on ?c)) (at-end (and "
      "(on ?a ?b) (power_on ?c)))))))",
      FormulaUse::Goal);
  EXPECT_TRUE(same_meaning(*read, *wanted)) << to_text(*read);
}

TEST(Phenomena, WhatIsNotToBeMindedIsNotAskedFor) {
  expect_goal("Turn on a lamp. Never mind the mug on the table.", "(exists (?a - Lamp) (at-end (power_on ?a)))");
  EXPECT_THAT(read("Turn on a lamp. Never mind the lamp on the table."), IsEmpty());  // there is none
}

TEST(Phenomena, AnExceptionIsNeverSo) {
  expect_goal(
      "Fill every mug but the dirty one with water.",
      "(and (forall (?a - (Mug :where (not (dirty ?a)))) (at-end (filled ?a water))) (always (forall (?b - (Mug "
      ":where (dirty ?b))) (not (filled ?b water)))))");
}

TEST(Phenomena, ACompoundNamesTheRoomOfAThing) {
  const auto readings = readings_of("Open the kitchen fridge.", NounTable(small_knowledge(), committed_names()));
  ASSERT_TRUE(readings) << format(readings.error());
  ASSERT_THAT(*readings, SizeIs(1));
  EXPECT_EQ(to_text((*readings)[0].goal),
            "(exists (?n1 - (Fridge :where (exists (?n2 - kitchen) (in_room ?n1 ?n2)))) (at-end (open ?n1)))");
}

TEST(Phenomena, SentencesAndPhrasesStandForThings) {
  const NounTable nouns(small_knowledge(), committed_names());
  const auto goal = [&](const char* text) {
    const auto read = parse_with(text, nouns);
    return read ? to_text(normal_form(*read)) : format(read.error());
  };
  const auto normal = [](const char* text) {
    return to_text(normal_form(*parse_formula("test", text, FormulaUse::Goal)));
  };
  EXPECT_EQ(goal("It's too dark to read."), normal("(exists (?a - Lamp) (at-end (power_on ?a)))"));
  EXPECT_EQ(goal("I'm thirsty. Wash what I need for that."), normal("(exists (?a - Mug) (at-end (clean ?a)))"));
  EXPECT_EQ(goal("Open the place where we keep the milk cold."), normal("(exists (?a - Fridge) (at-end (open ?a)))"));
  EXPECT_EQ(goal("Wash a piece of tableware."), normal("(exists (?a - (either Bowl Mug)) (at-end (clean ?a)))"));
  EXPECT_FALSE(parse_with("Wash what I need for that.", nouns));
}

TEST(Phenomena, TheWriterSaysOnlyWhatIsReadBack) {
  const std::string put_down = "(exists (?a - (Mug :where (exists (?t - Table) (on ?a ?t)))) (at-end (held ?a)))";
  const auto knowledge = small_knowledge();
  const auto text_of = [&](const std::string& goal, const char* style, std::uint64_t seed) {
    const auto written = write_instruction(asking(goal, style), knowledge, Rng(seed));
    EXPECT_TRUE(written) << format(written.error());
    EXPECT_EQ(name_of(written->style), style) << written->text;
    EXPECT_THAT(check_instruction(written->text, asking(goal, style), knowledge), IsEmpty()) << written->text;
    return written->text;
  };
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    EXPECT_THAT(text_of(put_down, "anaphora", seed), ::testing::StartsWith("There"));
    EXPECT_EQ(text_of("(exists (?a - Lamp) (at-end (power_on ?a)))", "request", seed), "It's too dark to read.");
  }
}

TEST(HomeSentences, AreTrueAndOfOtherThingsWhereTheGoalPutsSomething) {
  const auto knowledge = small_knowledge();
  const Formula goal = asking("(exists (?m - Mug) (exists (?t - Table) (at-end (on ?m ?t))))").goal;
  const auto told =
      home_sentences(home(), goal, {"Mug", "Table"}, knowledge, NounTable(knowledge, committed_names()), Rng(1));
  for (const auto& sentence : told) {
    EXPECT_THAT(sentence, Not(::testing::HasSubstr("mug")));
    EXPECT_THAT(sentence, ::testing::HasSubstr("where it is"));
    EXPECT_THAT(read(sentence + " Wash the dirty mug."), SizeIs(1)) << sentence;
  }
}

TEST(CanBeSaid, OnlyWhatTheHomeHas) {
  const NounTable nouns(small_knowledge(), committed_names());
  EXPECT_TRUE(can_be_said("I'm going to wash the mug.", home(), nouns));
  EXPECT_FALSE(can_be_said("I'm going to slice the apple.", home(), nouns));
  EXPECT_FALSE(can_be_said("I'm about to have some bread.", home(), nouns));
  EXPECT_TRUE(can_be_said("I'm about to have some bread.", Trace(), nouns)) << "nobody knows the home";
  EXPECT_TRUE(can_be_said("I just had a bowl of soup.", home(), nouns)) << "a measure, and no name";
  EXPECT_TRUE(can_be_said("I can't sleep with all those mugs here.", home(), nouns));
  EXPECT_FALSE(can_be_said("I can't sleep with all those lamps on.", home(), nouns)) << "there is one";
  EXPECT_TRUE(can_be_said("I want to bread the fish.", home(), nouns)) << "a verb";
  EXPECT_FALSE(can_be_said("I want the bread.", home(), nouns));
}

/// An occasion that speaks of what is not at home is not drawn; where all do, there is no text in that style.
TEST(CanBeSaid, DecidesWhichOccasionIsDrawn) {
  const auto small = small_knowledge();
  auto aliases = small.aliases();
  std::erase_if(aliases, [](const Alias& alias) { return alias.kind == AliasKind::Occasion; });
  for (const char* said : {"something to cut: I want some bread.", "something to cut: I want the mug."})
    aliases.push_back({"Mug", said, AliasKind::Occasion, {"curated", 1}});
  const Knowledge knowledge(small.simulator(), small.categories(), {}, {}, {}, aliases);
  Scene here;
  for (const char* category : {"Mug", "Mug", "Table"}) {
    Node node;
    node.id = lower(category) + "_" + std::to_string(here.nodes.size() + 1);
    node.category = category;
    here.nodes.push_back(node);
  }
  WritingOptions options;
  options.home = &here;
  const auto asked = asking("(exists (?m - Mug) (exists (?t - Table) (at-end (on ?m ?t))))", "context");
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto written =
        write_instruction(asked, knowledge, NounTable(knowledge, committed_names()), options, Rng(seed));
    ASSERT_TRUE(written) << format(written.error());
    EXPECT_EQ(written->style, Style::Context) << written->text;
    EXPECT_THAT(written->text, ::testing::StartsWith("I want the mug."));
  }
}

}  // namespace
}  // namespace unietp
