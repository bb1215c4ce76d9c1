// The pipeline writes a goal's tree, the validator reads it with code of its own: together they lose nothing.
#include "dataset/formula_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../logic/random_goals.h"
#include "record/tree_reader.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Result<Formula> read_back(const Json& json) {
  JsonReader reader("tree");
  const JsonAt root{json};
  auto formula = read_tree(reader, root);
  if (reader.error()) return *reader.error();
  return formula;
}

TEST(GoalTree, ReadsBackToTheSameFormulaForAnySeed) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    const auto goal = testing::GoalWriter(Rng(seed)).goal();
    const auto again = read_back(Json::parse(formula_to_json(goal).dump()));
    ASSERT_TRUE(again) << format(again.error()) << "\n" << to_text(goal);
    EXPECT_EQ(*again, goal) << to_text(goal) << "\n" << to_text(*again);
  }
}

/// Whatever one leaf of a tree is changed to, the reader refuses it or reads another formula; never the same one.
TEST(GoalTree, AChangedLeafIsNeverReadAsTheSameFormula) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const auto goal = testing::GoalWriter(Rng(seed)).goal();
    const Json tree = formula_to_json(goal);
    const Json flat = tree.flatten();
    for (const auto& [pointer, leaf] : flat.items()) {
      Json damaged = tree;
      auto& place = damaged[Json::json_pointer(pointer)];
      if (leaf.is_string()) place = leaf.get<std::string>() + "x";
      if (leaf.is_number()) place = leaf.get<int>() + 1;
      if (leaf.is_boolean()) place = !leaf.get<bool>();
      if (damaged == tree) continue;
      const auto read = read_back(damaged);
      EXPECT_TRUE(!read || *read != goal) << pointer << " " << damaged.dump();
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace unietp
