#pragma once

#include <algorithm>
#include <chrono>

namespace unietp {

/// Seconds as a duration of the steady clock; 0 for negative ones, and short enough to be added to the present.
inline std::chrono::steady_clock::duration seconds_long(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(std::clamp(seconds, 0.0, 1e8)));
}

}  // namespace unietp
