#include "simulation/cell_set.h"

#include <deque>
#include <vector>

#include <gtest/gtest.h>

#include "core/rng.h"
#include "simulation/distance_field.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

/// The steps from a cell to each one, row by row; -1 where there is no way. The plain way.
std::vector<int> steps_in(const CellSet& cells, int width, int height, int from_x, int from_y) {
  std::vector<int> steps(static_cast<std::size_t>(width * height), -1);
  const auto at = [&](int x, int y) -> int& { return steps[static_cast<std::size_t>(y * width + x)]; };
  std::deque<std::pair<int, int>> queue;
  if (cells.has(from_x, from_y)) {
    at(from_x, from_y) = 0;
    queue.emplace_back(from_x, from_y);
  }
  for (; !queue.empty(); queue.pop_front()) {
    const auto [x, y] = queue.front();
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      if (!cells.has(x + dx, y + dy) || at(x + dx, y + dy) >= 0) continue;
      at(x + dx, y + dy) = at(x, y) + 1;
      queue.emplace_back(x + dx, y + dy);
    }
  }
  return steps;
}

TEST(CellSet, WhatIsConnectedIsWhatAWalkReachesForAnySeed) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const int width = 1 + static_cast<int>(rng.below(200)), height = 1 + static_cast<int>(rng.below(30));
    const double open = rng.uniform(0.5, 0.95);
    CellSet cells(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) cells.set(x, y, rng.chance(open));
    }
    const int from_x = static_cast<int>(rng.below(static_cast<std::uint64_t>(width)));
    const int from_y = static_cast<int>(rng.below(static_cast<std::uint64_t>(height)));
    int in_row = 0;  // from there to the row's end
    for (int x = from_x; x < width; ++x) in_row += cells.has(x, from_y) ? 1 : 0;
    EXPECT_EQ(cells.count(from_y, from_x, width - 1), in_row);
    EXPECT_EQ(cells.count(from_y, from_x, from_x), cells.has(from_x, from_y) ? 1 : 0);
    EXPECT_EQ(cells.count(from_y, from_x, from_x - 1), 0);
    const auto steps = steps_in(cells, width, height, from_x, from_y);
    const CellSet connected = cells.connected_to(from_x, from_y);
    bool all = true;  // of the row's cells from there on are connected
    for (int x = from_x; x < width; ++x) {
      all = all && (connected.has(x, from_y) || !cells.has(x, from_y));
      EXPECT_EQ(connected.covers(cells, from_y, from_x, x), all) << x;
    }
    EXPECT_TRUE(cells.covers(connected, from_y, 0, width - 1));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x)
        ASSERT_EQ(connected.has(x, y), steps[static_cast<std::size_t>(y * width + x)] >= 0) << x << " " << y;
    }
    EXPECT_FALSE(connected.has(-1, 0) || connected.has(width, 0) || connected.has(0, height) || cells.has(0, -1));
  }
}

TEST(CellSet, WhatIsKnownOfAnotherSetChangesNothingForAnySeed) {
  int differ = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const int width = 40 + static_cast<int>(rng.below(160)), height = 20 + static_cast<int>(rng.below(30));
    const double open = rng.uniform(0.5, 0.98);
    CellSet before(width, height);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) before.set(x, y, rng.chance(open));
    }
    CellSet now = before;
    const int span = 1 + static_cast<int>(rng.below(6));
    const auto draw = [&](int below) { return static_cast<int>(rng.below(static_cast<std::uint64_t>(below))); };
    const int low_x = draw(width - span), low_y = draw(height - span);
    const double still_open = rng.chance(0.3) ? 0 : rng.chance(0.3) ? 1 : 0.5;
    for (int y = low_y; y < low_y + span; ++y) {
      for (int x = low_x; x < low_x + span; ++x) now.set(x, y, rng.chance(still_open));
    }
    for (int asked = 0; asked < 4; ++asked) {
      const int x = draw(width), y = draw(height);
      const CellSet reached = before.connected_to(x, y), anew = now.connected_to(x, y);
      EXPECT_EQ(now.connected_to(x, y, before, reached), anew) << x << " " << y;
      differ += anew == reached ? 0 : 1;
    }
  }
  EXPECT_GT(differ, 1000);
}

TEST(DistanceField, TheFewestStepsToARectangleAreThoseOfAWholeSearchWhateverWasAskedBefore) {
  const Scene scene = testing::kitchen();
  const NavigationGrid grid(scene, testing::kitchen_profile());
  const auto from = *grid.nearest_free(scene.agent.position);
  const auto steps = steps_in(grid.free_cells(), grid.width(), grid.height(), from.x, from.y);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    DistanceField ripple(grid, from);
    for (int asked = 0; asked < 40; ++asked) {
      const auto draw = [&](int count) {
        return static_cast<int>(rng.below(static_cast<std::uint64_t>(count + 4))) - 2;
      };
      const NavigationGrid::Cell low{draw(grid.width()), draw(grid.height())};
      const NavigationGrid::Cell high{low.x + static_cast<int>(rng.below(6)), low.y + static_cast<int>(rng.below(6))};
      int fewest = -1;
      for (int y = std::max(0, low.y); y <= std::min(grid.height() - 1, high.y); ++y) {
        for (int x = std::max(0, low.x); x <= std::min(grid.width() - 1, high.x); ++x) {
          const int here = steps[static_cast<std::size_t>(y * grid.width() + x)];
          if (here >= 0 && (fewest < 0 || here < fewest)) fewest = here;
        }
      }
      const int most = static_cast<int>(rng.below(60));
      const int bounded = ripple.fewest_to(low, high, most);
      EXPECT_TRUE(bounded == fewest || (bounded == -1 && fewest > most)) << bounded;
      EXPECT_EQ(ripple.fewest_to(low, high), fewest);
    }
  }
}

}  // namespace
}  // namespace unietp
