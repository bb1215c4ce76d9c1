#pragma once

#include <bitset>
#include <vector>

#include "audit/guess.h"
#include "audit/policies.h"
#include "core/rng.h"

namespace unietp {

/// Permutations that the chance of a policy is measured on.
inline constexpr std::size_t kPermutations = 1000;

/// Whether a policy's guess is right: first as the question is, then in each permutation.
using Guesses = std::bitset<1 + kPermutations>;

/// The guesses of each of the policies, which must be of the question's choice and of one channel; `pool` is of that
/// choice. Equal questions, models, pools and random streams give equal guesses.
std::vector<Guesses> play(const GuessQuestion& question, const std::vector<const ShortcutPolicy*>& policies,
                          const ModelsOfPart& models, const KindPool& pool, Rng rng);

}  // namespace unietp
