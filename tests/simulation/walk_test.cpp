// What is remembered of walking must be what would be found anew.
#include <set>

#include <gtest/gtest.h>

#include "simulation/flood_cache.h"
#include "simulation/shape.h"
#include "simulation/standing.h"
#include "simulation/world.h"
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
  FloodCache floods;
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
  FloodCache floods;
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
  const Shape shape = shape_of(mug);
  const StandingInputs asked{mug, shape, grid, walk, profile_};
  StandingCells cells;
  double before = 0;
  std::size_t count = 0;
  for (; const Vec2* at = cells.best(count, asked); ++count) {
    const double away = reach_distance(mug, *at, profile_);
    EXPECT_GE(away, before);
    EXPECT_LT(away, profile_.reach_m);
    const auto cell = grid.cell_at(*at);
    EXPECT_TRUE(walk.has(cell.x, cell.y));
    before = away;
  }
  EXPECT_GT(count, 10u);
  EXPECT_EQ(*cells.best(0, asked), *StandingCells().best(0, asked));
}

TEST_F(Walking, CellsToStandOnAreAllThatAreInReachAndOutOfTheDoorsWay) {
  constexpr double kReserve_m = 0.02;
  const NavigationGrid grid(scene_, profile_);
  const auto walk = grid.reached_from(*grid.nearest_free(scene_.agent.position));
  for (const char* id : {"mug_1", "fridge_1", "diningtable_1"}) {
    SCOPED_TRACE(id);
    const Node& node = *find_node(scene_, id);
    const Shape shape = shape_of(node);
    std::set<std::pair<double, double>> wanted, found;
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        const Vec2 at = grid.center({x, y});
        if (walk.has(x, y) && reach_distance(node, at, profile_) <= profile_.reach_m - kReserve_m &&
            !in_door_sweep(node, at, profile_))
          wanted.emplace(at.x(), at.y());
      }
    }
    StandingCells cells;
    std::size_t count = 0;
    for (; const Vec2* at = cells.best(count, {node, shape, grid, walk, profile_}); ++count)
      found.emplace(at->x(), at->y());
    EXPECT_EQ(found, wanted);
    EXPECT_EQ(count, wanted.size());
  }
}

TEST_F(Walking, IntoARoomLeadsToTheCellNearestToTheMiddleOfItsCorners) {
  const Knowledge knowledge = testing::kitchen_knowledge();
  const std::vector<std::vector<Vec2>> shapes = {{{0, 0}, {5, 0}, {5, 4}, {0, 4}},
                                                 {{0, 0}, {5, 0}, {5, 2.5}, {3, 2.5}, {3, 4}, {0, 4}},
                                                 {{0, 0}, {5, 1}, {2.5, 4}},
                                                 {{0.03, 0}, {5, 0}, {4.2, 3.9}, {1.1, 4}}};
  for (const auto& shape : shapes) {
    SCOPED_TRACE(shape.size());
    scene_.rooms.front().polygon = shape;
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : shape) middle += corner / static_cast<double>(shape.size());
    const NavigationGrid grid(scene_, profile_);
    const auto from = *grid.nearest_free(middle);
    scene_.agent.position = grid.center(from);
    const auto walk = grid.reached_from(from);
    std::optional<Vec2> nearest;  // the first of several
    for (int y = 0; y < grid.height(); ++y) {
      for (int x = 0; x < grid.width(); ++x) {
        const Vec2 at = grid.center({x, y});
        if (!walk.has(x, y) || !contains(shape, at)) continue;
        if (!nearest || (at - middle).squaredNorm() < (*nearest - middle).squaredNorm()) nearest = at;
      }
    }
    ASSERT_TRUE(nearest);
    auto world = World::create(scene_, knowledge, profile_);
    ASSERT_TRUE(world);
    ASSERT_TRUE(world->step({ActionType::GoTo, {scene_.rooms.front().id}}).success);
    EXPECT_EQ(world->agent().position, *nearest);
  }
}

}  // namespace
}  // namespace unietp
