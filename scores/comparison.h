#pragma once

#include <span>
#include <vector>

#include "core/result.h"
#include "scores/result_table.h"
#include "scores/scored_run.h"

namespace unietp {

/// Whether runs may stand in one table: the same benchmark or data set, by digest, and the same backend. Errors: Usage,
/// naming the two that differ.
Result<Done> check_comparable(std::span<const ScoredRun> runs);

/// Two runs on the episodes of a mode that both have finished.
struct PairComparison {
  std::size_t first = 0, second = 0;    // runs
  int tasks = 0;                        // that both have
  double difference = 0;                // success rate of the first less that of the second, on these tasks
  int only_first = 0, only_second = 0;  // tasks that one solved more often than the other
  double p = 1;                         // of the test itself: McNemar's, or with repeats the sign-flip over homes
  double corrected = 1;                 // Holm's, over all pairs of the mode
  bool differ() const { return corrected < 0.05; }
};
/// Every pair of runs, in order. Deterministic.
std::vector<PairComparison> compare_pairs(std::span<const ScoredRun> runs, Mode mode);

/// The places that a run may have among the others: between the runs that are better beyond doubt and those that are
/// worse.
struct RankRange {
  int best = 1, worst = 1;
};
/// By run.
std::vector<RankRange> ranks(std::size_t runs, const std::vector<PairComparison>& pairs);

/// Tables of ranks and of pairs for each mode that two runs have: ids "ranks-M1", "pairs-M1". Empty for one run.
std::vector<ResultTable> comparison_tables(std::span<const ScoredRun> runs);

}  // namespace unietp
