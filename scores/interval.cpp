#include "scores/interval.h"

#include <algorithm>
#include <cmath>

namespace unietp {

Interval wilson_interval(int successes, int trials) {
  if (trials == 0) return {};
  constexpr double kQuantile = 1.959963984540054;  // 97.5 % of the normal distribution
  constexpr double z2 = kQuantile * kQuantile;
  const double n = trials, p = successes / n;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kQuantile / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  // Exact at the ends, where rounding would leave 1e-17.
  return {p == 0 ? 0 : std::max(0.0, middle - half), p == 1 ? 1 : std::min(1.0, middle + half)};
}

}  // namespace unietp
