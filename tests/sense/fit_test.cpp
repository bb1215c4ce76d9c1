// The committed tables are what the fit writes.
#include "sense/fit.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/files.h"
#include "sense/category_kinds.h"
#include "tests/sense/committed_sense.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/needs.h"

namespace unietp {
namespace {

TEST(SenseFit, GivesTheCommittedKindsOfCategories) {
  const auto net = Hypernyms::read(Hypernyms::kFolder);
  if (!net) GTEST_SKIP() << needs::kWordNet;
  std::vector<Knowledge> knowledge;
  for (const auto simulator : kSimulators) knowledge.push_back(committed_knowledge(simulator));
  const auto& sense = test::committed_sense();
  const auto found = find_category_kinds(knowledge, sense.kinds(), test::committed_words(), *net);
  ASSERT_TRUE(found) << format(found.error());
  EXPECT_EQ(csv_of(*found), *read_file(test::sense_tables() / "categories.csv"));
}

TEST(SenseFit, GivesTheCommittedCountsOfTheStoredSources) {
  const std::filesystem::path upstream = UNIETP_UPSTREAM_DIR;
  const auto net = Hypernyms::read(Hypernyms::kFolder);
  if (!net || !std::filesystem::exists(upstream / "housekeep")) GTEST_SKIP() << needs::kSimulatorFiles;
  const auto& kinds = test::committed_sense().kinds();
  auto synsets = read_category_synsets(std::filesystem::path(UNIETP_SOURCE_DIR) / "data/bddl");
  ASSERT_TRUE(synsets);
  // Only a sample of the activities is stored there; the rows of the other sources do not depend on them.
  const auto items = read_items({upstream, upstream / "behavior/activity_definitions", {}},
                                {kinds, test::committed_words(), *net, std::move(*synsets)});
  ASSERT_TRUE(items) << format(items.error());
  const auto without_activities = [](std::vector<Evidence> rows) {
    std::erase_if(rows, [](const Evidence& row) { return row.source == "metadata:activity_definitions"; });
    return csv_of(rows);
  };
  std::vector<Error> errors;
  const auto committed = read_evidence(test::sense_tables() / "counts.csv", kinds, errors);
  EXPECT_EQ(without_activities(add_up(*items)), without_activities(committed));
}

TEST(SenseFit, NamesTheCategoriesWithoutAKind) {
  const Kinds kinds({{"thing", "thing", "things", "", "all", "", ""}});
  const auto net = Hypernyms::read(Hypernyms::kFolder);
  if (!net) GTEST_SKIP() << needs::kWordNet;
  const auto found = find_category_kinds({committed_knowledge(Simulator::Ai2thor)}, kinds, WordKinds({}, {}), *net);
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message.find("ai2thor:Mug"), std::string::npos);
}

}  // namespace
}  // namespace unietp
