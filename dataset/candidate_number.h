#pragma once

#include <cstdint>

#include "core/limits.h"
#include "core/rng.h"

namespace unietp {

/// The number of a candidate among all of a run: what its random streams are forked by. No two candidates share one,
/// since `attempt` is below limits::kAttempts.
inline std::uint64_t candidate_number(int slot, int attempt) {
  return static_cast<std::uint64_t>(slot) * limits::kAttempts + static_cast<std::uint64_t>(attempt);
}

/// The random stream of a task's instruction. The run's seed and the candidate name it, so rewriting the instructions
/// of a finished data set with the same seed gives the same texts.
inline Rng wording_stream(std::uint64_t seed, int slot, int attempt) {
  return Rng(seed).fork("annotator", candidate_number(slot, attempt));
}

}  // namespace unietp
