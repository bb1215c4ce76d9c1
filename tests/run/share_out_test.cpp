#include "run/share_out.h"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/rng.h"

namespace unietp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::vector<bool>> all_allowed(std::size_t rows, std::size_t columns) {
  return std::vector<std::vector<bool>>(rows, std::vector<bool>(columns, true));
}

TEST(ShareOut, MeetsTheSumsOfTheBenchmarkAndStaysWithinOneOfIndependentShares) {
  const std::vector<int> simulators{182, 82, 82, 190}, splits{42, 123, 130, 115, 126};
  const auto table = share_out(simulators, splits, all_allowed(4, 5));
  ASSERT_EQ(table.size(), 4U);
  std::vector<int> columns(5, 0);
  for (std::size_t r = 0; r < 4; ++r) {
    EXPECT_EQ(std::accumulate(table[r].begin(), table[r].end(), 0), simulators[r]);
    for (std::size_t c = 0; c < 5; ++c) {
      columns[c] += table[r][c];
      EXPECT_LT(std::abs(table[r][c] - simulators[r] * splits[c] / 536.0), 1.0) << r << " " << c;
    }
  }
  EXPECT_EQ(columns, splits);
}

TEST(ShareOut, MeetsAnySumsThatATableWithHolesCanHave) {
  Rng rng(5);
  for (int round = 0; round < 2000; ++round) {
    SCOPED_TRACE(round);
    const std::size_t rows = 1 + rng.below(4), columns = 1 + rng.below(5);
    auto allowed = all_allowed(rows, columns);
    std::vector<int> row_sums(rows, 0), column_sums(columns, 0);
    int total = 0;
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns; ++c) {  // the sums of some table with these holes
        allowed[r][c] = !rng.chance(0.4);
        const int count = allowed[r][c] ? static_cast<int>(rng.below(9)) : 0;
        row_sums[r] += count;
        column_sums[c] += count;
        total += count;
      }
    }
    if (total == 0) continue;
    const auto table = share_out(row_sums, column_sums, allowed);
    ASSERT_EQ(table.size(), rows);
    for (std::size_t c = 0; c < columns; ++c) {
      int sum = 0;
      for (std::size_t r = 0; r < rows; ++r) {
        sum += table[r][c];
        EXPECT_GE(table[r][c], 0);
        EXPECT_TRUE(allowed[r][c] || table[r][c] == 0);
      }
      EXPECT_EQ(sum, column_sums[c]);
    }
    for (std::size_t r = 0; r < rows; ++r) EXPECT_EQ(std::accumulate(table[r].begin(), table[r].end(), 0), row_sums[r]);
  }
}

TEST(ShareOut, GivesNothingWhereNoTableHasTheSums) {
  EXPECT_THAT(share_out({3}, {1, 2}, {{true, false}}), IsEmpty());
  EXPECT_THAT(share_out({3}, {2}, {{true}}), IsEmpty());
}

TEST(SpreadOut, LetsEachCellComeAsOftenAsItCountsAndEvenly) {
  EXPECT_THAT(spread_out({2, 0, 4}), ElementsAre(2, 0, 2, 2, 0, 2));
}

}  // namespace
}  // namespace unietp
