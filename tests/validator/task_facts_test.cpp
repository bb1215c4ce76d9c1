#include "validator/task_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "logic/formula.h"

namespace unietp::testing {
namespace {

using ::testing::ElementsAre;

TEST(TaskFacts, AMaterialIsNoCategoryOfThatName) {
  std::vector<Category> categories(3);
  categories[0].name = "coffee_table", categories[1].name = "glass", categories[2].name = "vase";
  const Knowledge knowledge(Simulator::Habitat, categories, {}, {}, {}, {});
  TaskRecord task;
  task.simulator = "habitat";
  task.bindings = {{"A", "vase"}, {"B", "coffee_table"}, {"M", "glass"}};
  const auto bound = [&](const char* goal, const char* start) {
    task.goal_tree = *parse_formula("goal", goal, FormulaUse::Goal);
    task.start_constraints = {start};
    return facts_of(task, {}, {}, {}, knowledge).bound_categories;
  };
  const char* on_glass =
      "(exists (?a - vase) (exists (?b - (coffee_table :where (material ?b glass))) (at-end (on ?a ?b))))";
  EXPECT_THAT(bound(on_glass, "(exists (?a - vase) (clean ?a))"), ElementsAre("habitat/coffee_table", "habitat/vase"));
  EXPECT_THAT(bound(on_glass, "(exists (?a - glass) (clean ?a))"),
              ElementsAre("habitat/coffee_table", "habitat/glass", "habitat/vase"));
}

}  // namespace
}  // namespace unietp::testing
