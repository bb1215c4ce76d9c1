#pragma once

#include <cstdint>

#include "core/rng.h"

namespace unietp {

/// The stream that a task's instruction is drawn from: the run's seed and the candidate name it, so that writing the
/// instructions of a finished data set anew with the same seed gives the same texts.
inline Rng wording_stream(std::uint64_t seed, int slot, int attempt) {
  return Rng(seed).fork("annotator", static_cast<std::uint64_t>(slot) * 1024 + static_cast<std::uint64_t>(attempt));
}

}  // namespace unietp
