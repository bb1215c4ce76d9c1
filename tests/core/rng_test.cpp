#include "core/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

namespace unietp {
namespace {

// SplitMix64 started at 1234567, as in the reference implementation's test vector (rosettacode.org, prng.di.unimi.it).
TEST(Rng, GivesTheKnownNumbersOfSplitMix64) {
  Rng rng(1234567);
  for (const std::uint64_t expected : {6457827717110365317ULL, 3203168211198807973ULL, 9817491932198370423ULL,
                                       4593380528125082431ULL, 16408922859458223821ULL}) {
    EXPECT_EQ(rng.next(), expected);
  }
}

TEST(Rng, AForkDependsOnSeedAndNameNotOnDraws) {
  Rng a(5), b(5);
  for (int i = 0; i < 10; ++i) b.next();
  EXPECT_EQ(a.fork("grounding", 3).next(), b.fork("grounding", 3).next());
  std::set<std::uint64_t> firsts;
  for (const char* stage : {"grounding", "generator", ""}) {
    for (std::uint64_t item = 0; item < 1000; ++item) firsts.insert(a.fork(stage, item).next());
  }
  EXPECT_EQ(firsts.size(), 3000U);
  EXPECT_NE(Rng(6).fork("grounding", 3).next(), a.fork("grounding", 3).next());
}

TEST(Rng, BelowIsUniformAndInRange) {
  Rng rng(1);
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(rng.below(7));
  for (const int count : counts) EXPECT_NEAR(count, 10000, 500);  // more than five standard deviations
  EXPECT_EQ(rng.below(1), 0U);
}

TEST(Rng, UnitUniformAndChanceKeepTheirBounds) {
  Rng rng(2);
  double sum = 0;
  int heads = 0;
  for (int i = 0; i < 20000; ++i) {
    const double unit = rng.unit();
    ASSERT_TRUE(unit >= 0 && unit < 1);
    sum += unit;
    const double between = rng.uniform(-3, -2);
    ASSERT_TRUE(between >= -3 && between < -2);
    heads += rng.chance(0.25) ? 1 : 0;
    ASSERT_FALSE(rng.chance(0));
    ASSERT_TRUE(rng.chance(1));
  }
  EXPECT_NEAR(sum / 20000, 0.5, 0.02);
  EXPECT_NEAR(heads, 5000, 400);
}

TEST(Rng, WeightedDrawsInProportionAndNeverWhatWeighsNothing) {
  Rng rng(3);
  const std::array<double, 4> weights = {1, 0, 3, 0};
  std::array<int, 4> counts{};
  for (int i = 0; i < 40000; ++i) ++counts.at(rng.weighted(weights));
  EXPECT_EQ(counts[1] + counts[3], 0);
  EXPECT_NEAR(counts[2], 30000, 600);
}

TEST(Rng, ShuffleKeepsTheItemsAndReachesEveryOrder) {
  Rng rng(4);
  std::set<std::vector<int>> orders;
  for (int i = 0; i < 500; ++i) {
    std::vector<int> items = {1, 2, 3, 4};
    rng.shuffle(items);
    orders.insert(items);
    std::sort(items.begin(), items.end());
    ASSERT_EQ(items, (std::vector<int>{1, 2, 3, 4}));
  }
  EXPECT_EQ(orders.size(), 24U);
}

}  // namespace
}  // namespace unietp
