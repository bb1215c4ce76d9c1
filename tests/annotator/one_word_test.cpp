// Texts as a model writes them, in which one word is replaced by one of another meaning: what the validator asks of a
// model's text (rewording/check_text.cpp) finds each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "annotator/instruction.h"
#include "annotator/word_check.h"
#include "small_knowledge.h"
#include "tests/support/committed_names.h"

namespace unietp {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;
using testing_support::asking;
using testing_support::small_knowledge;

std::vector<std::string> faults(const char* goal, const std::string& text) {
  static const NounTable nouns(small_knowledge(), committed_names());
  const auto specification = asking(goal);
  auto found = saying_faults(text, specification, nouns);
  if (auto other = misreading(text, specification, small_knowledge(), nouns, nullptr); !other.empty())
    found.push_back(std::move(other));
  return found;
}

constexpr const char* kOn = "(exists (?a - Mug) (exists (?b - Table) (at-end (on ?a ?b))))";
constexpr const char* kTwo = "(exists (?b - Table) (at-end (count = 2 (?a - Mug) (on ?a ?b))))";
constexpr const char* kThree = "(exists (?b - Table) (at-end (count >= 3 (?a - Apple) (on ?a ?b))))";
constexpr const char* kAll = "(exists (?b - Fridge) (forall (?a - Bowl) (at-end (inside ?a ?b))))";
constexpr const char* kClean =
    "(exists (?a - Mug) (exists (?b - Fridge) (and (before (clean ?a) (inside ?a ?b)) "
    "(at-end (inside ?a ?b)))))";
constexpr const char* kLamp = "(exists (?a - Lamp) (at-end (power_on ?a)))";
constexpr const char* kOpen = "(exists (?b - Fridge) (at-end (open ?b)))";
constexpr const char* kLarge = "(exists (?a - (Mug :where (size ?a large))) (at-end (clean ?a)))";

/// The words in `{right|wrong}` make the two texts.
struct OneWord {
  const char *goal, *text;
};
constexpr OneWord kTexts[] = {
    {kOn, "Could you get a {mug|bowl} and set it on a table?"},
    {kOn, "Please find a mug and {put|throw} it on a table."},
    {kOn, "I would like a mug to stand on a {table|fridge}."},
    {kOn, "Please put a mug {on|under} a table."},
    {kOn, "Bring a mug over and leave it on a table, {please|tomorrow}."},
    {kTwo, "Exactly {two|three} mugs should stand on one table."},
    {kTwo, "Please see to it that {exactly|roughly} two mugs are on a table."},
    {kTwo, "Make sure that exactly two {mugs|knives} are on a table."},
    {kTwo, "Exactly two mugs should {stand|break} on one table."},
    {kTwo, "I need exactly two mugs on a {table|lamp}, please."},
    {kThree, "Please put at {least|most} three apples on a table."},
    {kThree, "I want at least {three|four} apples on a table."},
    {kThree, "Get at least three {apples|mugs} and put them on a table."},
    {kThree, "Get at least three apples and {put|cut} them on a table."},
    {kThree, "At least three apples should be on a {table|fridge}, please."},
    {kAll, "Please store {all|none} of the bowls in a fridge."},
    {kAll, "{Every|No} bowl should go into a fridge."},
    {kAll, "All the {bowls|mugs} belong in a fridge, please."},
    {kAll, "Please put all the bowls {in|on} a fridge."},
    {kAll, "I want all the bowls {inside|outside} a fridge."},
    {kClean, "Rinse a {mug|bowl}, and only after that store it in a fridge."},
    {kClean, "{Wash|Fill} a mug before you put it in a fridge."},
    {kClean, "Wash a mug {before|after} you put it in a fridge."},
    {kClean, "Rinse a mug, and only after that put it in a {fridge|table}."},
    {kClean, "First wash a mug, then {keep|hide} it in a fridge."},
    {kLamp, "Could you please turn {on|off} a lamp?"},
    {kLamp, "Please switch a {lamp|fridge} on."},
    {kLamp, "I need some light, so {switch|knock} a lamp on."},
    {kLamp, "Please make sure that a lamp is {on|clean}."},
    {kLamp, "Please turn on {a|every} lamp."},
    {kOpen, "Please {open|close} a fridge for me."},
    {kOpen, "I'd like you to open a {fridge|bread}."},
    {kOpen, "Please leave a fridge {open|closed}."},
    {kOpen, "Please see to it that a fridge is {open|empty}."},
    {kOpen, "Please open a {fridge|mug} for me."},
    {kLarge, "Please wash the {larger|smaller} mug."},
    {kLarge, "Please {wash|dirty} the larger mug."},
    {kLarge, "The larger {mug|knife} needs to be washed."},
    {kLarge, "The larger mug needs to be {washed|filled}."},
    {kLarge, "Please wash the {larger|red} mug."},
};

std::string with(const std::string& text, bool right) {
  const auto open = text.find('{'), bar = text.find('|'), close = text.find('}');
  const auto word = right ? text.substr(open + 1, bar - open - 1) : text.substr(bar + 1, close - bar - 1);
  return text.substr(0, open) + word + text.substr(close + 1);
}

// The goals of further texts: an order of two kinds of things to do, a choice by a state, and where something goes.
constexpr const char* kPutThenLight =
    "(exists (?a - Lamp) (exists (?b - Table) (and (before (on ?a ?b) (power_on ?a)) (at-end (and (on ?a ?b) (power_on "
    "?a))))))";
constexpr const char* kIfOpen =
    "(or (exists (?a - (Fridge :where (open ?a))) (exists (?b - Bowl) (at-end (inside ?b ?a)))) (exists (?a - (Fridge "
    ":where (closed ?a))) (exists (?b - Bowl) (exists (?c - Table) (at-end (on ?b ?c))))))";
constexpr const char* kCutThenCooked =
    "(exists (?a - Apple) (and (before (sliced ?a) (cooked ?a)) (at-end (cooked ?a))))";
constexpr const char* kFilled = "(exists (?a - Mug) (at-end (filled ?a water)))";
constexpr const char* kCleanOn = "(exists (?a - Mug) (exists (?b - Table) (at-end (and (clean ?a) (on ?a ?b)))))";
constexpr OneWord kOrdersAndChoices[] = {
    {kPutThenLight, "Put a lamp on a table {before|once} it is turned on."},
    {kCutThenCooked, "Please cut an apple {before|after} you cook it."},
    {kFilled, "Please pour water {into|over} a mug."},
    {kFilled, "Please pour water {into|from} a mug."},
    {kCleanOn, "Please wash a mug and place it {on|off} a table."},
    {kPutThenLight, "Set the lamp on a table, and {after|before} that turn it on."},
    {kPutThenLight, "Put a lamp on a table {before|after} you turn it on."},
    {kPutThenLight, "{After|Before} you put a lamp on a table, turn it on."},
    {kIfOpen, "If the fridge happens to be {open|closed}, the bowl goes in it. If not, put the bowl on a table."},
    {kIfOpen, "Put the bowl in the fridge if the fridge is {open|closed}. If not, put the bowl on a table."},
    {kIfOpen, "If the fridge is {closed|open}, put the bowl on a table. If it is open, put the bowl in it."},
};

TEST(OneWord, OfAnotherOrderCaseOrDirectionIsFound) {
  for (const auto& [goal, text] : kOrdersAndChoices) {
    EXPECT_THAT(faults(goal, with(text, true)), IsEmpty()) << text;
    EXPECT_THAT(faults(goal, with(text, false)), Not(IsEmpty())) << text;
  }
}

TEST(OneWord, OfAnotherMeaningIsFoundInEachOfFortyTexts) {
  EXPECT_EQ(std::size(kTexts), 40U);
  for (const auto& [goal, text] : kTexts) {
    EXPECT_THAT(faults(goal, with(text, true)), IsEmpty()) << text;
    EXPECT_THAT(faults(goal, with(text, false)), Not(IsEmpty())) << text;
  }
}

}  // namespace
}  // namespace unietp
