#include "core/pause.h"

#include <algorithm>
#include <cstdint>
#include <ctime>

namespace unietp {

bool pause_until(std::chrono::steady_clock::time_point time, const std::atomic<bool>* stop) {
  using std::chrono::nanoseconds;
  for (;;) {
    if (stop != nullptr && *stop) return false;
    const auto left = std::chrono::duration_cast<nanoseconds>(time - std::chrono::steady_clock::now()).count();
    if (left <= 0) return true;
    constexpr long kLongest_ns = 50'000'000;
    const timespec pause{0, static_cast<long>(std::min<std::int64_t>(left, kLongest_ns))};
    (void)::nanosleep(&pause, nullptr);
  }
}

}  // namespace unietp
