#pragma once

#include <atomic>
#include <chrono>

namespace unietp {

/// Waits until a time of the steady clock, or until `stop` is true (noticed within 0.05 s); it may be null. False when
/// stopped.
bool pause_until(std::chrono::steady_clock::time_point time, const std::atomic<bool>* stop);

}  // namespace unietp
