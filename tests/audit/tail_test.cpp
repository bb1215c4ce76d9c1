#include "audit/tail.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/rng.h"

namespace unietp {
namespace {

TEST(ChanceOfAtLeast, IsTheBinomialTailForEqualChances) {
  EXPECT_DOUBLE_EQ(chance_of_at_least(0, {0.1, 0.2}), 1);
  EXPECT_NEAR(chance_of_at_least(2, {0.5, 0.5, 0.5}), 0.5, 1e-15);
  EXPECT_NEAR(chance_of_at_least(3, {0.5, 0.5, 0.5}), 0.125, 1e-15);
  EXPECT_NEAR(chance_of_at_least(20, std::vector<double>(20, 0.1)) / 1e-20, 1, 1e-9);
}

TEST(ChanceOfAtLeast, IsTheSumOverAllOutcomes) {
  const std::vector<double> chances{0.9, 0.05, 0.4, 0.0, 1.0, 0.3, 0.7};
  std::vector<double> at_least(chances.size() + 2, 0);
  for (unsigned outcome = 0; outcome < 1U << chances.size(); ++outcome) {
    double probability = 1;
    std::size_t hits = 0;
    for (std::size_t i = 0; i < chances.size(); ++i) {
      const bool hit = (outcome >> i & 1U) != 0;
      hits += hit ? 1 : 0;
      probability *= hit ? chances[i] : 1 - chances[i];
    }
    for (std::size_t k = 0; k <= hits; ++k) at_least[k] += probability;
  }
  for (std::size_t k = 0; k < at_least.size(); ++k)
    EXPECT_NEAR(chance_of_at_least(static_cast<int>(k), chances), at_least[k], 1e-14) << k;
}

}  // namespace
}  // namespace unietp
