#include "sense/special_places.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "sense/usual_places.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> problems_of(const std::string& rows) {
  const ScratchFolder folder;
  EXPECT_TRUE(write_file(folder.path() / "special_places.csv", "places,holds,source\n" + rows));
  std::vector<Error> errors;
  (void)read_special_places(folder.path() / "special_places.csv", test::committed_sense().kinds(), errors);
  std::vector<std::string> texts;
  for (const auto& error : errors) texts.push_back(format(error));
  return texts;
}

TEST(SpecialPlaces, HoldWhatTheyAreMadeForAndOthersHoldAnything) {
  const auto& kinds = test::committed_sense().kinds();
  const auto& places = test::committed_sense().special_places();
  EXPECT_TRUE(places.may_hold("wine fridge", "alcohol", kinds));  // of a narrower kind than `drink`
  EXPECT_FALSE(places.may_hold("wine fridge", "dairy", kinds));
  EXPECT_FALSE(places.may_hold("bookcase", "fruit", kinds));
  EXPECT_FALSE(places.may_hold("gravy boat", "fruit", kinds));  // holds nothing that can be carried
  EXPECT_TRUE(places.may_hold("fridge", "dairy", kinds));
}

TEST(SpecialPlaces, EachIsCalledAsACategoryIs) {
  std::set<std::string> names;
  for (const auto simulator : kSimulators) {
    for (const auto& category : committed_knowledge(simulator).categories())
      names.insert(normal_word(category.display));
  }
  for (const auto& [place, holds] : test::committed_sense().special_places().all())
    EXPECT_TRUE(names.contains(place)) << place;
}

TEST(SenseRules, SpeakOfThingsThatAreCalledSo) {
  std::set<std::string> names;
  for (const auto simulator : kSimulators) {
    for (const auto& category : committed_knowledge(simulator).categories()) {
      names.insert(normal_word(category.display));
      names.insert("slice_of_" + normal_word(category.display));
    }
  }
  std::vector<Error> errors;
  std::size_t spoken_of = 0;
  for (const auto& rule :
       read_sense_rules(test::sense_tables() / "rules.csv", test::committed_sense().kinds(), errors)) {
    for (const auto& word : rule.words) EXPECT_TRUE(names.contains(word)) << rule.name << ": " << word;
    spoken_of += rule.words.size();
  }
  EXPECT_TRUE(errors.empty());
  EXPECT_GT(spoken_of, 50U);
}

TEST(SpecialPlaces, HaveNoPlacementsOfOtherThings) {
  const auto& sense = test::committed_sense();
  for (const auto simulator : kSimulators) {
    const auto& knowledge = committed_knowledge(simulator);
    for (const auto& row : knowledge.placements()) {
      const auto &thing = *knowledge.find(row.object), &place = *knowledge.find(row.receptacle);
      if (!thing.movable || (row.relation != Predicate::On && row.relation != Predicate::Inside)) continue;
      const auto kind = sense.kind_of(simulator, row.object)->kind;
      EXPECT_TRUE(sense.special_places().may_hold(place.display, kind, sense.kinds()))
          << row.object << " " << row.receptacle;
    }
  }
}

TEST(SpecialPlaces, AFaultyRowIsToldWithItsPlace) {
  EXPECT_THAT(problems_of("wine_fridge|wine_rack,drink,curated\nteapot,-,curated\n"), IsEmpty());
  EXPECT_THAT(problems_of("wine_fridge,drnk,curated\n"),
              Contains(HasSubstr("2:13: schema error: 'drnk' is not a kind")));
  EXPECT_THAT(problems_of("teapot,-,curated\nteapot,drink,curated\n"), Contains(HasSubstr("'teapot' stands twice")));
}

}  // namespace
}  // namespace unietp
