#pragma once

#include <cstdint>
#include <string_view>

#include "core/rng.h"

namespace unietp {

/// A number that stands for a word of some sort ("state", "kind"): equal words have equal numbers, different ones
/// practically never.
inline std::uint64_t word_key(std::string_view word, std::uint64_t sort = 0) { return Rng(sort).fork(word, 0).next(); }

}  // namespace unietp
