#include "scores/interval.h"

#include <algorithm>
#include <cmath>

#include "scores/normal.h"

namespace unietp {

Interval wilson_interval(int successes, int trials) {
  if (trials == 0) return {};
  const double n = trials, p = successes / n, z2 = kNormal975 * kNormal975;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kNormal975 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  // Exact at the ends, where rounding would leave 1e-17.
  return {successes == 0 ? 0 : std::max(0.0, middle - half), successes == trials ? 1 : std::min(1.0, middle + half)};
}

}  // namespace unietp
