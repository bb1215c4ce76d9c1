#pragma once

#include <cmath>
#include <numbers>

namespace unietp {

/// The 97.5 % quantile of the normal distribution.
inline constexpr double kNormal975 = 1.959963984540054;

/// The normal distribution function.
inline double normal_share_below(double z) { return std::erfc(-z / std::numbers::sqrt2) / 2; }

}  // namespace unietp
