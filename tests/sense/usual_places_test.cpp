#include "sense/usual_places.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/simulator.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/committed_knowledge.h"

namespace unietp {
namespace {

using ::testing::Contains;
using ::testing::Not;

const UsualPlaces& places(Simulator simulator) {
  static const std::map<Simulator, UsualPlaces> all = [] {
    std::map<Simulator, UsualPlaces> made;
    for (const auto each : kSimulators)
      made.emplace(each, UsualPlaces(committed_knowledge(each), test::committed_sense()));
    return made;
  }();
  return all.at(simulator);
}

std::vector<std::string> names(const std::vector<UsualPlace>& found) {
  std::vector<std::string> all;
  for (const auto& place : found) all.push_back(place.placement->receptacle);
  return all;
}

TEST(UsualPlaces, AreWherePeopleKeepThings) {
  const auto mug = names(places(Simulator::Ai2thor).best_of("Mug"));
  EXPECT_THAT(mug, Contains("CounterTop"));
  EXPECT_THAT(mug, Contains("Cabinet"));
  EXPECT_THAT(mug, Not(Contains("Bed")));
  EXPECT_THAT(names(places(Simulator::Virtualhome).best_of("toothpaste")), Contains("bathroomcabinet"));
  EXPECT_THAT(names(places(Simulator::Habitat).best_of("book")), Contains("bookcase"));
}

TEST(UsualPlaces, OfEachGradeHaveWeightsThatSumToOneTheHeaviestFirst) {
  for (const auto simulator : kSimulators) {
    for (const auto& category : committed_knowledge(simulator).categories()) {
      SCOPED_TRACE(category.name);
      std::map<Grade, double> sum;
      const UsualPlace* last = nullptr;
      for (const auto& place : places(simulator).of(category.name)) {
        EXPECT_NE(place.grade, Grade::Senseless);
        EXPECT_EQ(place.placement->object, category.name);
        if (last != nullptr) {
          EXPECT_LE(place.grade, last->grade);
          EXPECT_TRUE(last->grade != place.grade || place.weight <= last->weight);
        }
        sum[place.grade] += place.weight;
        last = &place;
      }
      for (const auto& [grade, total] : sum) EXPECT_NEAR(total, 1, 1e-9);
    }
  }
}

TEST(UsualPlaces, OfAThingWithoutAnyAreNone) {
  EXPECT_TRUE(places(Simulator::Ai2thor).of("NoSuchThing").empty());
  EXPECT_TRUE(places(Simulator::Ai2thor).best_of("NoSuchThing").empty());
}

TEST(UsualPlaces, AreTheTolerableOnesWhereNoneIsUsual) {
  std::vector<Category> categories(3);
  categories[0].name = "Apple";
  categories[1].name = "Bin";
  categories[2].name = "Bowl";
  const Knowledge knowledge(Simulator::Ai2thor, categories, {},
                            {{"Apple", Predicate::Inside, "Bin", 0.5, 1, {"curated", 1}},
                             {"Apple", Predicate::Inside, "Bowl", 0.5, 1, {"curated", 1}}},
                            {}, {});
  const CommonSense sense(Kinds({{"thing", "thing", "things", "", "all", "", ""},
                                 {"food", "food", "food", "thing", "eaten", "", ""},
                                 {"bowl", "bowl", "bowls", "thing", "holds", "in", ""},
                                 {"bin", "bin", "bins", "thing", "rubbish", "in", ""}}),
                          {{{Simulator::Ai2thor, "Apple"}, {"food", "curated"}},
                           {{Simulator::Ai2thor, "Bowl"}, {"bowl", "curated"}},
                           {{Simulator::Ai2thor, "Bin"}, {"bin", "curated"}}},
                          {{{"food", "in:bowl"}, Grade::Tolerable}, {{"food", "in:bin"}, Grade::Senseless}}, {}, {});
  const UsualPlaces small(knowledge, sense);
  const auto best = small.best_of("Apple");
  ASSERT_EQ(best.size(), 1U);
  EXPECT_EQ(best.front().placement->receptacle, "Bowl");
  EXPECT_EQ(best.front().grade, Grade::Tolerable);
  EXPECT_EQ(grade_placement(knowledge.placements().front(), knowledge, sense).grade, Grade::Senseless);
}

}  // namespace
}  // namespace unietp
