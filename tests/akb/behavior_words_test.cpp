// The rules that make words, bodies and phrases of BEHAVIOR's categories.
#include <gtest/gtest.h>

#include "akb/group_phrases.h"
#include "akb/import_behavior.h"
#include "akb/wordnet_words.h"
#include "core/files.h"
#include "tests/akb/small_tables.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

using behavior::body_of;
using behavior::Facts;

Facts thing(const Vec3& box, double mass = 0.5) {
  Facts facts;
  facts.mass = mass;
  facts.models = {{"thing-a", box}};
  return facts;
}

TEST(BehaviorBodies, ARoundBottleStandsAndAFlatOneThatWouldFallLies) {
  const auto round = body_of(thing({0.25, 0.08, 0.078}), Archetype::Cylinder);  // upstream it lies
  EXPECT_EQ(round.archetype, Archetype::Cylinder);
  EXPECT_EQ(round.size, Vec3(0.079, 0.079, 0.25));
  const auto flat = body_of(thing({0.07, 0.03, 0.2}), Archetype::Cylinder);
  EXPECT_EQ(flat.archetype, Archetype::Box);
  EXPECT_EQ(flat.size, Vec3(0.2, 0.07, 0.03));
}

TEST(BehaviorBodies, ACoinIsACylinderOnItsSide) {
  const auto coin = body_of(thing({0.002, 0.024, 0.024}), Archetype::Cylinder);
  EXPECT_EQ(coin.archetype, Archetype::Cylinder);
  EXPECT_EQ(coin.size, Vec3(0.024, 0.024, 0.005));
  EXPECT_EQ(coin.source.source, "derived:smallest-body");
}

TEST(BehaviorBodies, OnlyWhatIsNearlyRoundIsABall) {
  EXPECT_EQ(body_of(thing({0.07, 0.074, 0.074}), Archetype::Sphere).archetype, Archetype::Sphere);
  EXPECT_EQ(body_of(thing({0.1, 0.07, 0.07}), Archetype::Sphere).archetype, Archetype::Box);
}

TEST(BehaviorBodies, ClothIsFolded) {
  Facts towel = thing({1.1, 0.57, 0.03});
  towel.properties.insert("cloth");
  const auto body = body_of(towel, Archetype::Box);
  EXPECT_LE(body.size.maxCoeff(), 0.42);
  EXPECT_EQ(body.source.source, "derived:folded");
}

TEST(GroupPhrases, TheNearestGroupSpeaks) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.path() / "phrases.csv",
                         "group,kind,text\ncutlery,function,something to eat with\n"
                         "knife.n.01,function,something to cut with\ncutlery,context,The table has to be set.\n"));
  std::vector<Error> errors;
  const auto phrases = read_group_phrases(folder.path() / "phrases.csv", errors);
  EXPECT_TRUE(errors.empty());
  const std::vector<std::string> groups{"parer.n.02", "knife.n.01", "cutlery"};
  EXPECT_EQ(phrases.of(groups, AliasKind::Function), (std::vector<std::string>{"something to cut with"}));
  EXPECT_EQ(phrases.of(groups, AliasKind::Context), (std::vector<std::string>{"The table has to be set."}));
  EXPECT_TRUE(phrases.of({"spoon"}, AliasKind::Function).empty());
}

TEST(GroupPhrases, AnUnknownKindOfPhraseIsAnErrorAtItsPlace) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.path() / "phrases.csv", "group,kind,text\ncutlery,use,something to eat with\n"));
  std::vector<Error> errors;
  read_group_phrases(folder.path() / "phrases.csv", errors);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors.front().pos, (SourcePos{2, 9}));
}

TEST(WordNetWords, AreThoseOfWhichTheSynsetIsTheFirstSense) {
  const auto words = WordNetWords::read(WordNetWords::kFolder);
  if (!words) GTEST_SKIP() << needs::kWordNet;
  EXPECT_EQ(words->usual_words("sofa.n.01"), (std::vector<std::string>{"sofa", "couch", "lounge"}));
  EXPECT_TRUE(words->usual_words("mug.n.04").empty()) << "a mug is first of all something else";
  EXPECT_TRUE(words->has("mug.n.04"));
  EXPECT_FALSE(words->has("mug.n.40"));
  EXPECT_FALSE(words->has("half__apple.n.01"));
  EXPECT_TRUE(words->usual_words("no synset").empty());
}

TEST(WordNetWords, AWordThatTheIndexLacksIsNoUsualWord) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.path() / "data.noun", "00000000 06 n 03 mug 0 Beaker 0 tea_mug 0 000 | a vessel\n"));
  ASSERT_TRUE(write_file(folder.path() / "index.noun", "mug n 1 0 1 1 00000000\ntea_mug n 1 0 1 0 00000000\n"));
  const auto words = WordNetWords::read(folder.path());
  ASSERT_TRUE(words) << format(words.error());
  EXPECT_EQ(words->usual_words("mug.n.01"), (std::vector<std::string>{"mug", "tea mug"}));
}

TEST(WordNetWords, AMissingFileIsAnError) {
  const ScratchFolder folder;
  const auto words = WordNetWords::read(folder.path());
  ASSERT_FALSE(words);
  EXPECT_EQ(words.error().kind, Error::Kind::Io);
}

}  // namespace
}  // namespace unietp
