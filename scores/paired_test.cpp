#include "scores/paired_test.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace unietp {

double mcnemar_test(int only_first, int only_second) {
  const int n = only_first + only_second, fewer = std::min(only_first, only_second);
  if (n == 0 || 2 * fewer == n) return 1;
  double log_chance = -n * std::numbers::ln2, sum = 0;  // of k successes, k = 0, 1, ...
  for (int k = 0; k <= fewer; ++k) {
    sum += std::exp(log_chance);
    log_chance += std::log(static_cast<double>(n - k) / (k + 1));
  }
  return std::min(1.0, 2 * sum);
}

double sign_flip_test(std::span<const double> differences, Rng rng, int draws) {
  std::vector<double> moved;
  for (const double one : differences) {
    if (one != 0) moved.push_back(one);
  }
  const double observed = std::abs(std::accumulate(moved.begin(), moved.end(), 0.0));
  // Sums of the same numbers in another order differ in the last bits.
  const double as_far = observed * (1 - 1e-9) - 1e-12;
  std::uint64_t extreme = 0;
  if (moved.size() <= kExactDifferences) {
    const std::uint64_t all = std::uint64_t{1} << moved.size();
    for (std::uint64_t signs = 0; signs < all; ++signs) {
      double sum = 0;
      for (std::size_t i = 0; i < moved.size(); ++i) sum += (signs >> i & 1) != 0 ? -moved[i] : moved[i];
      if (std::abs(sum) >= as_far) ++extreme;
    }
    return static_cast<double>(extreme) / static_cast<double>(all);
  }
  for (int draw = 0; draw < draws; ++draw) {
    double sum = 0;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (i % 64 == 0) bits = rng.next();
      sum += (bits >> (i % 64) & 1) != 0 ? -moved[i] : moved[i];
    }
    if (std::abs(sum) >= as_far) ++extreme;
  }
  return static_cast<double>(extreme + 1) / (draws + 1.0);
}

std::vector<double> holm(std::vector<double> probabilities) {
  std::vector<std::size_t> order(probabilities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return probabilities[a] < probabilities[b]; });
  double before = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    double& one = probabilities[order[i]];
    before = std::max(before, std::min(1.0, one * static_cast<double>(order.size() - i)));
    one = before;
  }
  return probabilities;
}

}  // namespace unietp
