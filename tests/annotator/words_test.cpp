#include "annotator/words_for_reading.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "annotator/naming.h"
#include "annotator/words_for_writing.h"
#include "sense/action_roles.h"

namespace unietp {
namespace {

bool reads(std::span<const PredicatePhrase> forms, const std::string& words, Predicate predicate) {
  return std::any_of(forms.begin(), forms.end(),
                     [&](const PredicatePhrase& form) { return form.words == words && form.predicate == predicate; });
}

TEST(Words, EveryWrittenStateAndRelationIsReadAsWhatItSays) {
  for (const PredicateInfo& row : all_predicates()) {
    const std::string state = state_word(row.predicate), preposition = before_object(row.predicate);
    EXPECT_TRUE(state.empty() || reads(state_phrases(), state, row.predicate)) << row.name;
    // "in the kitchen" is read as inside, and the room makes it in_room.
    const Predicate read = row.predicate == Predicate::InRoom ? Predicate::Inside : row.predicate;
    EXPECT_TRUE(preposition.empty() || reads(preposition_phrases(), preposition, read)) << row.name;
  }
}

TEST(Words, EveryPredicateThatAnActionCanChangeHasWords) {
  constexpr std::array kFixed{Predicate::Color, Predicate::Material, Predicate::Size};  // words of their own
  for (const PredicateInfo& row : all_predicates()) {
    Complement asked;
    asked.predicate = row.predicate;
    if (std::find(kFixed.begin(), kFixed.end(), row.predicate) != kFixed.end()) continue;
    EXPECT_FALSE(state_word(row.predicate).empty() && before_object(row.predicate).empty() && verbs(asked).empty())
        << row.name << " has no row in annotator/words_for_writing.cpp";
  }
}

TEST(Words, EveryStateThatIsAskedForByAVerbHasARole) {
  for (const PredicateInfo& row : all_predicates()) {
    Complement asked;
    asked.predicate = row.predicate;
    const bool state = row.arguments.size() == 1;
    if (!state || verbs(asked).empty() || row.predicate == Predicate::Thawed)
      continue;  // sense/action_roles.h says why
    EXPECT_NE(action_of(row.predicate), "") << row.name << " has no row in sense/action_roles.cpp";
  }
  for (const StateAction& row : state_actions()) {
    EXPECT_FALSE(row.role.empty() || row.verbs.front().empty()) << info(row.predicate).name;
    const auto forms = verb_phrases();
    EXPECT_TRUE(std::any_of(forms.begin(), forms.end(),
                            [&](const PredicatePhrase& form) { return form.predicate == row.predicate; }))
        << info(row.predicate).name << " has no verb in annotator/words_for_reading.cpp";
  }
}

TEST(Words, OfFormsThatBeginAlikeTheLongerIsTriedFirst) {
  for (const auto forms : {state_phrases(), preposition_phrases(), symbol_phrases(), verb_phrases()}) {
    ASSERT_FALSE(forms.empty());
    for (std::size_t i = 0; i < forms.size(); ++i) {
      for (std::size_t k = i + 1; k < forms.size(); ++k)
        EXPECT_FALSE(forms[k].words.starts_with(std::string(forms[i].words) + " ")) << forms[k].words;
    }
  }
}

TEST(Words, NumbersUpToTwelveAreWordsAndOthersDigits) {
  EXPECT_EQ(number_word(0), "zero");
  EXPECT_EQ(number_word(2), "two");
  EXPECT_EQ(number_word(12), "twelve");
  EXPECT_EQ(number_word(13), "13");
  EXPECT_EQ(number_word(-1), "-1");
}

TEST(Words, AVerbMayHaveWordsAfterItsObject) {
  const auto verbs = verb_phrases();
  const auto cut =
      std::find_if(verbs.begin(), verbs.end(), [](const PredicatePhrase& verb) { return verb.words == "cut"; });
  ASSERT_NE(cut, verbs.end());
  EXPECT_EQ(cut->after, "into slices");
  EXPECT_FALSE(cut->optional);
  const auto heat =
      std::find_if(verbs.begin(), verbs.end(), [](const PredicatePhrase& verb) { return verb.words == "heat"; });
  ASSERT_NE(heat, verbs.end());
  EXPECT_EQ(heat->after, "up");
  EXPECT_TRUE(heat->optional);
}

}  // namespace
}  // namespace unietp
