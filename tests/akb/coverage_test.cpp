#include "akb/coverage.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "akb/table_words.h"
#include "akb/tables.h"
#include "tests/akb/small_tables.h"

namespace unietp {
namespace {

template <class Pairs>
const auto& named(const Pairs& pairs, const std::string& name) {
  return std::find_if(pairs.begin(), pairs.end(), [&](const auto& pair) { return pair.first == name; })->second;
}

TEST(Coverage, CountsFactsByKindAndSourceWithTheirMeanConfidence) {
  const auto coverage = coverage_of(test::small_knowledge());
  EXPECT_EQ(coverage.categories, 6U);
  const FactCounts& affordances = named(coverage.tables, "affordance");
  EXPECT_EQ(affordances.facts, 5U);
  EXPECT_DOUBLE_EQ(affordances.mean_confidence(), (4 + 0.9) / 5);
  EXPECT_EQ(affordances.by_kind, (std::map<std::string, std::size_t>{{"curated", 4}, {"metadata", 1}}));
  EXPECT_EQ(affordances.by_source.at("metadata:types.json"), 1U);
  EXPECT_EQ(named(coverage.tables, "relation").by_kind,
            (std::map<std::string, std::size_t>{{"derived", 1}, {"llm", 1}}));
  EXPECT_EQ(named(coverage.affordances, "pickupable").facts, 2U);
  EXPECT_EQ(named(coverage.affordances, "foldable").facts, 0U);
  EXPECT_EQ(coverage.affordances.size(), affordance_names().size());
}

TEST(Coverage, NamesTheCategoriesThatLackSomething) {
  const auto coverage = coverage_of(test::small_knowledge());
  using Names = std::vector<std::string>;
  EXPECT_EQ(named(coverage.missing, "synset"), (Names{"fridge", "half_apple"}));
  EXPECT_EQ(named(coverage.missing, "rooms"), Names{});
  EXPECT_EQ(named(coverage.missing, "placements"), (Names{"half_apple", "knife", "mug"}));
  EXPECT_EQ(named(coverage.missing, "aliases"), (Names{"apple", "fridge", "half_apple", "knife", "plate"}));
}

TEST(Coverage, OfTheCommittedTablesIsTheirSize) {
  for (const auto simulator : kSimulators) {
    const auto tables = test::committed(simulator);
    const auto coverage = coverage_of(test::knowledge_of(simulator, tables));
    EXPECT_EQ(coverage.categories, tables.categories.size());
    EXPECT_EQ(named(coverage.tables, "relation").facts, tables.placements.size());
    std::size_t afforded = 0;
    for (const auto& [name, counted] : coverage.affordances) afforded += counted.facts;
    EXPECT_EQ(afforded, tables.affordances.size());
  }
}

}  // namespace
}  // namespace unietp
