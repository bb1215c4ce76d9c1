#pragma once

namespace unietp {

/// The 97.5 % quantile of the normal distribution.
inline constexpr double kNormal975 = 1.959963984540054;

}  // namespace unietp
