// The phrases by which an instruction can mean a thing without its name.
#include <algorithm>
#include <cctype>
#include <set>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace unietp
