#include "core/least_first.h"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/keep_least.h"
#include "core/rng.h"

namespace unietp {
namespace {

TEST(LeastFirst, GivesWhatSortingWouldAndMeasuresOnlyWhatMayComeBeforeForAnySeed) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    struct Thing {
      int place, bound, measure;
      bool counts;
    };
    std::vector<Thing> things;
    for (int place = 0; place < 30; ++place) {
      const int measure = static_cast<int>(rng.below(12));
      things.push_back({place, measure - static_cast<int>(rng.below(4)), measure, rng.chance(0.9)});
    }
    std::vector<int> measured(things.size(), 0);
    const std::size_t most = 1 + rng.below(35);
    LeastFirst<int, int> least(most, [&](int place) -> std::optional<int> {
      const Thing& thing = things[static_cast<std::size_t>(place)];
      ++measured[static_cast<std::size_t>(place)];
      return thing.counts ? std::optional(thing.measure) : std::nullopt;
    });
    for (const Thing& thing : things) least.add(thing.place, thing.bound);

    std::vector<Thing> sorted = things;
    std::erase_if(sorted, [](const Thing& thing) { return !thing.counts; });
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Thing& a, const Thing& b) { return a.measure < b.measure; });
    sorted.resize(std::min(sorted.size(), most));
    for (const Thing& expected : sorted) {
      const auto next = least.next();
      ASSERT_TRUE(next);
      EXPECT_EQ(*next, expected.place);
      for (const Thing& thing : things) {
        const int times = measured[static_cast<std::size_t>(thing.place)];
        EXPECT_LE(times, thing.bound <= expected.measure ? 1 : 0) << thing.place;
      }
    }
    EXPECT_FALSE(least.next());
  }
}

TEST(KeepLeast, KeepsTheFirstOfEqualsAndLeavesFewAsTheyAre) {
  std::vector<int> things{31, 12, 30, 11, 10};
  keep_least(things, 5, [](int thing) { return thing / 10; });
  EXPECT_EQ(things, (std::vector{31, 12, 30, 11, 10}));
  keep_least(things, 4, [](int thing) { return thing / 10; });
  EXPECT_EQ(things, (std::vector{12, 11, 10, 31}));
}

}  // namespace
}  // namespace unietp
