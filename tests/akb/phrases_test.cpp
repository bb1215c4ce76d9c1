// The phrases by which an instruction can mean a thing without its name.
#include <algorithm>
#include <cctype>
#include <set>

#include <gtest/gtest.h>

#include "akb/lay_kinds.h"
#include "akb/lay_phrases.h"
#include "core/files.h"
#include "core/text.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

class Phrases : public ::testing::TestWithParam<Simulator> {
 protected:
  std::set<std::string> phrased(AliasKind kind) const {
    std::set<std::string> names;
    for (const auto& a : tables.aliases) {
      if (a.kind == kind) names.insert(a.category);
    }
    return names;
  }
  Tables tables = test::committed(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Homes, Phrases,
                         ::testing::Values(Simulator::Ai2thor, Simulator::Virtualhome, Simulator::Habitat),
                         [](const auto& simulator) { return std::string(name_of(simulator.param)); });

TEST_P(Phrases, SayOfEveryMovableWhenOneNeedsIt) {
  const auto contexts = phrased(AliasKind::Context), synonyms = phrased(AliasKind::Synonym);
  for (const auto& c : tables.categories) {
    if (!c.movable) continue;
    EXPECT_TRUE(contexts.contains(c.name)) << c.name;
  }
  EXPECT_GE(synonyms.size(), tables.categories.size() / 2);
}

TEST_P(Phrases, DoNotNameTheThingThatTheyMean) {
  for (const auto& a : tables.aliases) {
    if (a.kind == AliasKind::Synonym) continue;
    const auto& c = test::category(tables, a.category);
    const std::string text = " " + lower(a.text) + " ";
    EXPECT_EQ(text.find(" " + lower(c.display) + " "), std::string::npos) << a.category << ": " << a.text;
  }
}

TEST_P(Phrases, AreNounPhrasesOrWholeSentences) {
  for (const auto& a : tables.aliases) {
    const bool sentence = std::isupper(static_cast<unsigned char>(a.text.front())) && a.text.ends_with('.');
    if (a.kind == AliasKind::Context) {
      EXPECT_TRUE(sentence) << a.text;
    } else {
      EXPECT_FALSE(a.text.ends_with('.')) << a.text;
    }
  }
}

/// What data/sense/phrases.csv adds to the committed tables.
std::vector<Tables> with_phrases() {
  std::vector<Tables> all;
  for (const Simulator simulator : kSimulators) all.push_back(test::committed(simulator));
  std::vector<Error> errors;
  lay_kinds(test::committed_tables(), all, errors);
  lay_phrases(test::committed_tables(), all, errors);
  for (const Error& error : errors) ADD_FAILURE() << format(error);
  return all;
}

TEST(LaidPhrases, KnowCategoriesByTheirNamesAndByWhatTheyAreCalled) {
  const auto all = with_phrases();
  const auto is_snack = [&](const std::string& category) {
    return std::any_of(all.begin(), all.end(), [&](const Tables& tables) {
      return std::any_of(tables.aliases.begin(), tables.aliases.end(), [&](const Alias& alias) {
        return alias.category == category && alias.text == "a snack" && alias.kind == AliasKind::Hypernym;
      });
    });
  };
  for (const char* snack : {"creamybuns", "crackers", "cup_of_yogurt", "apple"}) EXPECT_TRUE(is_snack(snack)) << snack;
  for (const char* other : {"poundcake", "half_tiramisu", "cheesecake", "watermelon", "coconut_fruit"})
    EXPECT_FALSE(is_snack(other)) << other;
}

}  // namespace
}  // namespace unietp
