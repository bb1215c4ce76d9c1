#include "annotator/words_for_reading.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "annotator/naming.h"
#include "annotator/words_for_writing.h"

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
