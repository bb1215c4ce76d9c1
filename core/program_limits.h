#pragma once

#include <cstddef>
#include <cstdint>

/// Limits on what the program takes from options, requests and services, beside those of core/limits.h.
namespace unietp::limits {

inline constexpr int kThreads = 1024;                    // of one command
inline constexpr std::uint32_t kHeaderBytes = 16 << 10;  // of a request to `unietp serve` over HTTP, before its body

// Files for a provider's batch service, which takes as many requests and 200 MB. What is more goes into further files.
inline constexpr std::size_t kBatchLines = 50'000;
inline constexpr std::size_t kBatchBytes = std::size_t{190} << 20;

}  // namespace unietp::limits
