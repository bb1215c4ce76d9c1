#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "grounding/failure.h"
#include "grounding/home.h"
#include "logic/formula.h"

namespace unietp {

/// The fewest and the most that may satisfy a count for it to be true (or false); the most may be INT_MAX.
std::pair<int, int> count_range(Comparison comparison, int n, bool truth);

/// What speaks at once against making a home meet start constraints: rooms neither come nor go, and a home from which
/// more than a score of things of one kind were taken out would not be that home any more. nullopt:
/// nothing does, as far as numbers say.
std::optional<GroundingFailure> refused_by_numbers(const std::vector<Formula>& constraints, const Home& home,
                                                   const Knowledge& knowledge);

}  // namespace unietp
