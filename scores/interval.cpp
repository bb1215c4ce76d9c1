#include "scores/interval.h"

#include <algorithm>
#include <cmath>

#include "scores/normal.h"

namespace unietp {

Interval wilson_interval(int successes, int trials) {
  if (trials == 0) return {};
  return wilson_interval(successes / static_cast<double>(trials), trials, kNormal975);
}

Interval wilson_interval(double rate, double trials, double quantile) {
  const double n = trials, p = rate, z2 = quantile * quantile;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = quantile / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  // Exact at the ends, where rounding would leave 1e-17.
  return {p == 0 ? 0 : std::max(0.0, middle - half), p == 1 ? 1 : std::min(1.0, middle + half)};
}

}  // namespace unietp
