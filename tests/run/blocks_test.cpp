#include "run/blocks.h"

#include <gtest/gtest.h>

namespace unietp {
namespace {

std::vector<TaskSlot> slots(int count) {
  std::vector<TaskSlot> all;
  for (int i = 0; i < count; ++i)
    all.push_back(
        {i, kSimulators[static_cast<std::size_t>(i) % kSimulators.size()], Split::Atomic, {0}, {Grade::Usual}, 0, {}});
  return all;
}

/// Blocks cover the slots in order, and no home stands in two of them.
void expect_apart(const std::vector<Block>& blocks, int count) {
  int next = 0;
  BlockHomes used{};
  for (const Block& block : blocks) {
    EXPECT_EQ(block.first(), next);
    next += static_cast<int>(block.slots.size());
    for (std::size_t s = 0; s < used.size(); ++s) {
      EXPECT_EQ(block.homes[s].first, used[s].count);
      EXPECT_GT(block.homes[s].count, 0);
      used[s].count += block.homes[s].count;
    }
  }
  EXPECT_EQ(next, count);
}

int homes_of(int count, int block) {
  RunConfiguration configuration;
  configuration.block = block;
  const auto blocks = blocks_of(configuration, {}, slots(count));
  expect_apart(blocks, count);
  int homes = 0;
  for (const Block& one : blocks) homes += one.homes[0].count;
  return homes;
}

TEST(BlocksOf, AHomeForEveryFiveTasksThenForEvery25) {
  EXPECT_EQ(homes_of(40, 256), 2);
  EXPECT_EQ(homes_of(41, 256), 3);
  EXPECT_EQ(homes_of(200, 40), 10);
  EXPECT_EQ(homes_of(1200, 2000), 20);      // 300 of a simulator
  EXPECT_NEAR(homes_of(1200, 100), 20, 5);  // each block has a whole number of homes
}

TEST(BlocksOf, TheBenchmarksHomesAreSharedOutToTheLastOne) {
  RunConfiguration configuration;
  configuration.homes = HomeSource::Benchmark;
  configuration.block = 10;
  Resources resources;
  for (const Simulator simulator : kSimulators) {
    for (int i = 0; i < (simulator == Simulator::Habitat ? 3 : 7); ++i)
      resources.benchmark.push_back({std::to_string(i), simulator, 1, 7, 210});
  }
  const auto blocks = blocks_of(configuration, resources, slots(100));
  ASSERT_EQ(blocks.size(), 3U);  // no more than Habitat has homes
  expect_apart(blocks, 100);
  EXPECT_EQ(blocks.back().homes[0].first + blocks.back().homes[0].count, 7);
  EXPECT_EQ(blocks.back().homes[2], (HomeRange{2, 1}));
}

TEST(BlocksOf, AFewTasksAreOneBlock) { EXPECT_EQ(blocks_of({}, {}, slots(3)).size(), 1U); }

}  // namespace
}  // namespace unietp
