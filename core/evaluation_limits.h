#pragma once

#include <cstddef>

/// Limits of evaluations, beside those of core/limits.h.
namespace unietp::limits {

// What is kept of the text of an episode, so that its line can be read again (kLineBytes).
inline constexpr std::size_t kReplyBytes = std::size_t{32} << 10;    // of one reply; what follows is cut off
inline constexpr std::size_t kRepliesBytes = std::size_t{3} << 20;   // of all replies of an episode, shared evenly
inline constexpr std::size_t kThinkingBytes = std::size_t{2} << 20;  // of an episode; the log has the rest
inline constexpr int kEvaluatedSteps = 10'000;                       // that an evaluated episode may be allowed
// Of a package of Python modules that acts, whose digests are recorded.
inline constexpr std::size_t kPackageFiles = 10'000;

}  // namespace unietp::limits
