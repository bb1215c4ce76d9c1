#pragma once

namespace unietp {

/// A 95 % confidence interval of a rate.
struct Interval {
  double low = 0, high = 1;  // in [0, 1]
  bool operator==(const Interval&) const = default;
};

/// Wilson's score interval for `successes` of `trials` independent trials; [0, 1] without trials. Source: Wilson 1927,
/// "Probable inference, the law of succession, and statistical inference", Journal of the American Statistical
/// Association 22; without continuity correction.
Interval wilson_interval(int successes, int trials);

}  // namespace unietp
