// Every bound that an answer is held against, one answer a bound.
#include <gmock/gmock.h>

#include "akb/complete_answer.h"
#include "core/files.h"
#include "tests/akb/small_tables.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

Tables small() {
  const ScratchFolder folder;
  test::write_small_tables(folder.path(), test::small_tables());
  std::vector<Error> errors;
  auto tables = read_tables(folder.path() / "behavior", errors);
  for (const auto& error : errors) ADD_FAILURE() << format(error);
  return tables;
}

CheckedAnswer checked(const std::string& answer, std::vector<FactKind> facts,
                      std::vector<std::string> categories = {"knife"}) {
  static const Tables tables = small();
  static const auto wordnet = WordNet::read("/usr/share/wordnet");
  return check_completion(answer, tables, {std::move(categories), std::move(facts)}, {"llm:m", 0.5},
                          wordnet ? &*wordnet : nullptr);
}

std::size_t accepted_in(const CheckedAnswer& answer) {
  const auto& a = answer.accepted;
  return a.sizes.size() + a.masses.size() + a.synsets.size() + a.affordances.size() + a.placements.size() +
         a.aliases.size();
}

struct Bad {
  FactKind kind;
  const char* value;
  const char* reason;
};

TEST(CompletionAnswer, WhatIsOutOfBoundsIsRejectedWithItsReason) {
  const Bad kOutOfBounds[] = {
      {FactKind::Size, "3", "not in the requested form"},
      {FactKind::Size, R"({"width":1,"depth":1})", "not in the requested form"},
      {FactKind::Size, R"({"width":1,"depth":"1","height":1})", "not in the requested form"},
      {FactKind::Size, R"({"width":0,"depth":1,"height":1})", "out of bounds"},
      {FactKind::Size, R"({"width":-1,"depth":1,"height":1})", "out of bounds"},
      {FactKind::Size, R"({"width":1e308,"depth":1,"height":1})", "out of bounds"},
      {FactKind::Size, R"({"width":21,"depth":1,"height":1})", "out of bounds"},
      {FactKind::Size, R"({"width":9,"depth":9,"height":9})", "not possible with its size and mass"},
      {FactKind::Mass, "\"light\"", "not in the requested form"},
      {FactKind::Mass, "2001", "out of bounds"},
      {FactKind::Mass, "0", "out of bounds"},
      {FactKind::Mass, "30", "not possible with its size and mass"},
      {FactKind::Synset, "[]", "not in the requested form"},
      {FactKind::Synset, "\"knife\"", "not the name of a synset"},
      {FactKind::Synset, "\"knife.v.01\"", "not the name of a synset"},
      {FactKind::Synset, "\"knife.n.1\"", "not the name of a synset"},
      {FactKind::Synset, "\"knife.n.00\"", "not the name of a synset"},
      {FactKind::Aliases, "\"blade\"", "not in the requested form"},
      {FactKind::Aliases, "[3]", "not in the requested form"},
      {FactKind::Aliases, R"(["x"])", "too short"},
      {FactKind::Aliases, R"(["Blade"])", "not lower-case English words"},
      {FactKind::Aliases, R"(["blade "])", "not lower-case English words"},
      {FactKind::Aliases, R"(["blade  thing"])", "not lower-case English words"},
      {FactKind::Aliases, R"(["knife_3"])", "not lower-case English words"},
      {FactKind::Aliases, "[\"l\xC3\xA2me\"]", "not lower-case English words"},
      {FactKind::Aliases, R"(["blade\nnow"])", "not lower-case English words"},
      {FactKind::Aliases, R"(["knives"])", "already its name"},
      {FactKind::Aliases, R"(["plates"])", "the name of another category"},
      {FactKind::Aliases, R"(["blade","blade"])", "a duplicate"},
      {FactKind::Aliases, R"(["blade","cutter","slicer","parer","chopper"])", "more than requested"},
      {FactKind::Function, R"(["cutting bread"])", "does not start like a function phrase"},
      {FactKind::Function, R"(["something"])", "does not start like a function phrase"},
      {FactKind::Function, R"(["algo para cortar"])", "does not start like a function phrase"},
      {FactKind::Function, R"(["a thing"])", "too short"},
      {FactKind::Function, R"(["a knife to cut bread with"])", "names the object itself"},
      {FactKind::Context, R"(["i must cut."])", "not one plain sentence"},
      {FactKind::Context, R"(["I must cut"])", "not one plain sentence"},
      {FactKind::Context, R"(["I must. Cut it."])", "not one plain sentence"},
      {FactKind::Context, R"(["Ignore this: <b>it</b>."])", "not one plain sentence"},
      {FactKind::Context, R"(["Necesito cortar pan."])", "not English"},
      {FactKind::Context, R"(["I cut."])", "too short"},
      {FactKind::Affordances, R"(["edible"])", "an unknown affordance"},
      {FactKind::Affordances, R"(["openable"])", "not possible with its shape"},
      {FactKind::Affordances, R"(["container"])", "not possible with its shape"},
      {FactKind::Affordances, R"(["breakable","breakable"])", "a duplicate"},
      {FactKind::Placements, R"(["fridge"])", "not in the requested form"},
      {FactKind::Placements, R"([{"relation":"inside","receptacle":"fridge"}])", "not in the requested form"},
      {FactKind::Placements, R"([{"relation":"inside","receptacle":"fridge","likelihood":2}])", "out of bounds"},
      {FactKind::Placements, R"([{"relation":"behind","receptacle":"fridge","likelihood":1}])", "an unknown relation"},
      {FactKind::Placements, R"([{"relation":"inside","receptacle":"Fridge","likelihood":1}])", "an unknown category"},
      {FactKind::Placements, R"([{"relation":"on","receptacle":"fridge","likelihood":1}])", "does not fit there"},
      {FactKind::Placements, R"([{"relation":"inside","receptacle":"knife","likelihood":1}])", "does not fit there"},
      {FactKind::Placements,
       R"([{"relation":"inside","receptacle":"fridge","likelihood":1},{"relation":"inside","receptacle":"fridge","likelihood":1}])",
       "a duplicate"},
  };
  for (const auto& bad : kOutOfBounds) {
    SCOPED_TRACE(std::string(name_of(bad.kind)) + " " + bad.value);
    const auto answer =
        checked(R"({"categories":[{"category":"knife",")" + std::string(name_of(bad.kind)) + "\":" + bad.value + "}]}",
                {bad.kind});
    ASSERT_EQ(answer.rejected.size(), 1U);
    EXPECT_EQ(answer.rejected[0].reason, bad.reason);
    EXPECT_EQ(answer.rejected[0].category, "knife");
    EXPECT_EQ(answer.rejected[0].fact, name_of(bad.kind));
    EXPECT_LE(answer.rejected[0].value.size(), 63U);
  }
}

TEST(CompletionAnswer, WhatIsWithinBoundsIsTaken) {
  const auto answer = checked(
      R"({"categories":[{"category":"knife","size":{"width":0.30004,"depth":0.03,"height":0.02},"mass":0.15049,
          "synset":"knife.n.01","aliases":["kitchen blade"],"function":["something to cut bread with"],
          "context":["I'd like a slice of bread, and it is uncut."],"affordances":["dirtyable","pickupable"],
          "placements":[{"relation":"inside","receptacle":"fridge","likelihood":0.1}]}]})",
      {all_fact_kinds().begin(), all_fact_kinds().end()});
  EXPECT_THAT(answer.rejected, IsEmpty());
  EXPECT_EQ(accepted_in(answer), 9U);
  EXPECT_EQ(answer.accepted.sizes.at(0).size, Vec3(0.3, 0.03, 0.02));
  EXPECT_EQ(answer.accepted.masses.at(0).mass, 0.15);
  EXPECT_EQ(answer.accepted.placements.at(0).capacity, 12);
  EXPECT_EQ(answer.accepted.placements.at(0).source.source, "llm:m");
}

TEST(CompletionAnswer, NothingIsTakenThatWasNotAsked) {
  const std::string fact = R"(,"function":["something to cut with"],"mass":0.2})";
  const auto answer = checked(R"({"categories":[{"category":"knife")" + fact + R"(,{"category":"mug")" + fact +
                                  R"(,{"category":"sword")" + fact + R"(,{"category":"knife")" + fact + ",3]}",
                              {FactKind::Function}, {"knife", "plate"});
  EXPECT_EQ(accepted_in(answer), 1U);
  std::vector<std::string> reasons;
  for (const auto& rejected : answer.rejected) reasons.push_back(rejected.reason);
  EXPECT_THAT(reasons, ElementsAre("a category that was not requested", "an unknown category", "a duplicate",
                                   "an entry without a category", "missing from the answer"));
}

TEST(CompletionAnswer, AnEmptyListOrSynsetIsNeitherTakenNorRejected) {
  const auto answer = checked(R"({"categories":[{"category":"knife","aliases":[],"synset":"","function":null}]})",
                              {FactKind::Synset, FactKind::Aliases, FactKind::Function});
  EXPECT_EQ(accepted_in(answer), 0U);
  EXPECT_THAT(answer.rejected, IsEmpty());
}

TEST(CompletionAnswer, OfAnotherFormIsRejectedAsAWhole) {
  for (const std::string& text : {std::string("{}"), std::string("[]"), std::string(R"({"categories":{}})"),
                                  std::string("no"), std::string(), std::string(100000, '[')}) {
    const auto answer = checked(text, {FactKind::Mass});
    ASSERT_EQ(answer.rejected.size(), 1U);
    EXPECT_EQ(answer.rejected[0].reason, "no list of categories in the answer");
  }
}

TEST(CompletionAnswer, ASynsetMustBeWordNets) {
  if (!WordNet::read("/usr/share/wordnet")) GTEST_SKIP() << needs::kWordNet;
  for (const char* synset : {"knife.n.99", "knifle.n.01"}) {
    const auto answer =
        checked(R"({"categories":[{"category":"knife","synset":")" + std::string(synset) + "\"}]}", {FactKind::Synset});
    ASSERT_EQ(answer.rejected.size(), 1U);
    EXPECT_EQ(answer.rejected[0].reason, "not a synset of WordNet 3.0");
  }
}

TEST(CompletionRequest, SaysWhatIsKnownAndAsksWhatIsNot) {
  const auto tables = small();
  const auto batches = completion_batches(tables, {FactKind::Mass, FactKind::Synset, FactKind::Placements}, 8);
  ASSERT_EQ(batches.size(), 3U);  // synset alone; synset and placements; placements alone
  EXPECT_THAT(batches[0].categories, ElementsAre("fridge"));
  EXPECT_THAT(batches[1].categories, ElementsAre("half_apple"));
  EXPECT_THAT(batches[2].categories, ElementsAre("knife", "mug", "plate"));
  const auto request = completion_request(tables, batches[2]);
  EXPECT_THAT(request.user, HasSubstr("- knife: knife, plural knives; can be carried; shape box; 0.3 x 0.04 x 0.02 m"));
  EXPECT_THAT(request.user, HasSubstr("also called cup, with a handle; serves as something to drink from"));
  EXPECT_THAT(request.user, HasSubstr("Receptacles for inside: fridge"));
  EXPECT_THAT(request.user, Not(HasSubstr("apple")));
  EXPECT_THAT(request.schema, HasSubstr(R"("required":["category","placements"])"));
  EXPECT_THAT(request.system, Not(HasSubstr("WordNet")));
}

}  // namespace
}  // namespace unietp
