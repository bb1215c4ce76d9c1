// Rows of simulators, and the data that each must have.
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "scene/simulator_info.h"
#include "scene/states.h"

namespace unietp {
namespace {

const std::filesystem::path kData = std::filesystem::path(UNIETP_SOURCE_DIR) / "data";

TEST(Simulators, HaveNamesAndTitlesOfTheirOwn) {
  std::set<std::string_view> names, titles;
  for (const Simulator simulator : kSimulators) {
    const SimulatorInfo& row = info(simulator);
    EXPECT_EQ(row.simulator, simulator);
    EXPECT_EQ(simulator_named(row.name), simulator);
    EXPECT_FALSE(row.title.empty());
    names.insert(row.name);
    titles.insert(row.title);
  }
  EXPECT_EQ(names.size(), kSimulators.size());
  EXPECT_EQ(titles.size(), kSimulators.size());
  EXPECT_FALSE(simulator_named("AI2-THOR"));
}

TEST(Simulators, ShowTheStatesOfTheirRows) {
  for (const auto& row : all_predicates()) {
    if (row.group.empty()) continue;
    EXPECT_TRUE(shows(Simulator::Ai2thor, row.predicate)) << row.name;
    EXPECT_TRUE(shows(Simulator::Behavior, row.predicate)) << row.name;
    EXPECT_EQ(shows(Simulator::Habitat, row.predicate), row.predicate == Predicate::Open) << row.name;
    EXPECT_EQ(shows(Simulator::Virtualhome, row.predicate),
              row.predicate == Predicate::Open || row.predicate == Predicate::PowerOn)
        << row.name;
  }
}

TEST(Simulators, HaveTheTablesThatContributingLists) {
  for (const Simulator simulator : kSimulators) {
    const std::string name(name_of(simulator));
    std::set<std::string> wanted{"simulators/" + name + ".json", "akb/curated/" + name + "/category.csv"};
    for (const char* table : {"affordance", "alias", "asset", "category", "effect", "relation"})
      wanted.insert("akb/" + name + "/" + table + ".csv");
    for (const char* part : {"", "_objects", "_receptacles", "_rooms"})
      wanted.insert("layouts/" + name + part + ".csv");
    for (const std::string& file : wanted) EXPECT_TRUE(std::filesystem::is_regular_file(kData / file)) << file;
  }
}

}  // namespace
}  // namespace unietp
