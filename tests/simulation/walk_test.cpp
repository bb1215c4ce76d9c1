// What is remembered of walking must be what would be found anew.
#include <gtest/gtest.h>

#include "simulation/floods.h"
#include "simulation/shape.h"
#include "simulation/standing.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

class Walking : public ::testing::Test {
 protected:
  void swing(NavigationGrid& grid, const std::string& id, double opening) {
    Node& node = *edit_node(scene_, id);
    node.opening = opening;
    const Shape shape = shape_of(node);
    grid.update(NodeIndex(scene_.nodes).find(id).value(), &node, &shape);
  }

  Scene scene_ = testing::kitchen();
  Profile profile_ = testing::kitchen_profile();
};

TEST_F(Walking, ADoorThatShutsAgainLeavesTheGridAsItWas) {
  NavigationGrid grid(scene_, profile_);
  const Digest shut = grid.digest();
  swing(grid, "fridge_1", 1);
  EXPECT_NE(grid.digest(), shut);
  EXPECT_EQ(grid.digest(), NavigationGrid(scene_, profile_).digest());
  swing(grid, "fridge_1", 0);
  EXPECT_EQ(grid.digest(), shut);
}

TEST_F(Walking, AFloodIsFoundAgainAndIsRight) {
  NavigationGrid grid(scene_, profile_);
  const auto here = *grid.nearest_free(scene_.agent.position);
  const auto beside = NavigationGrid::Cell{here.x + 1, here.y};
  ASSERT_TRUE(grid.free(beside));
  Floods floods;
  const std::uint64_t first = floods.around(grid, here).number;
  EXPECT_EQ(floods.around(grid, beside).number, first);  // where one gets is the same
  EXPECT_EQ(floods.steps(grid, here, beside, beside), 1);
  EXPECT_EQ(floods.steps(grid, beside, beside, beside), 0);  // how far it is, is not
  swing(grid, "fridge_1", 1);
  EXPECT_NE(floods.around(grid, here).number, first);
  EXPECT_EQ(floods.around(grid, here).to, grid.reached_from(here));
  swing(grid, "fridge_1", 0);
  EXPECT_EQ(floods.around(grid, here).number, first);
}

TEST_F(Walking, OnlyAFewFloodsAreKept) {
  NavigationGrid grid(scene_, profile_);
  Floods floods;
  const auto first = *grid.nearest_free(scene_.agent.position);
  const std::uint64_t number = floods.around(grid, first).number;
  for (double opening = 0; opening < 1; opening += 0.1) {
    swing(grid, "fridge_1", opening);
    EXPECT_EQ(floods.around(grid, first).to, grid.reached_from(first));
  }
  swing(grid, "fridge_1", 0);
  EXPECT_NE(floods.around(grid, first).number, number);
  EXPECT_EQ(floods.around(grid, first).to, grid.reached_from(first));
}

TEST_F(Walking, CellsToStandOnComeBestFirstAndEachOnce) {
  const NavigationGrid grid(scene_, profile_);
  const auto walk = grid.reached_from(*grid.nearest_free(scene_.agent.position));
  const Node& mug = *find_node(scene_, "mug_1");
  StandingCells cells(mug, shape_of(mug), grid, walk, profile_);
  double before = 0;
  std::size_t count = 0;
  for (; const Vec2* at = cells.best(count); ++count) {
    const double away = reach_distance(mug, *at, profile_);
    EXPECT_GE(away, before);
    EXPECT_LT(away, profile_.reach_m);
    const auto cell = grid.cell_at(*at);
    EXPECT_TRUE(walk.has(cell.x, cell.y));
    before = away;
  }
  EXPECT_GT(count, 10u);
  EXPECT_EQ(*cells.best(0), *StandingCells(mug, shape_of(mug), grid, walk, profile_).best(0));
}

}  // namespace
}  // namespace unietp
