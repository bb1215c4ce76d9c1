#pragma once

#include <span>
#include <vector>

#include "core/rng.h"
#include "scores/clustered_interval.h"

namespace unietp {

/// Draws with replacement, as many clusters as there are, `draws` times; the success rate of each draw, sorted.
/// Deterministic in its arguments. Empty without episodes.
std::vector<double> bootstrap_rates(std::span<const ClusterCount> clusters, Rng rng, int draws);

/// The value below which a share of sorted numbers lies, by linear interpolation (type 7 of Hyndman and Fan 1996, the
/// default of numpy). `sorted` is not empty.
double quantile_of(std::span<const double> sorted, double share);

/// The 2.5 and 97.5 % quantiles of 2,000 draws: the usual interval of a rate when tasks of one home resemble each
/// other, which in few homes covers rare successes too seldom. [0, 1] without episodes.
Interval bootstrap_interval(std::span<const ClusterCount> clusters, Rng rng);

}  // namespace unietp
