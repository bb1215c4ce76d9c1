#pragma once

#include <span>
#include <vector>

#include "core/rng.h"
#include "scores/interval.h"

namespace unietp {

/// What the tasks of one home add to a mean: the sum of their values and how many values there were.
struct ClusterSum {
  double sum = 0, count = 0;
  bool operator==(const ClusterSum&) const = default;
};

/// Draws with replacement, as many clusters as there are, `draws` times; the mean of each draw, sorted. Deterministic
/// in its arguments. Empty without clusters.
std::vector<double> bootstrap_means(std::span<const ClusterSum> clusters, Rng rng, int draws);

/// The value below which a share of sorted numbers lies, by linear interpolation (type 7 of Hyndman and Fan 1996, the
/// default of numpy). `sorted` is not empty.
double quantile_of(std::span<const double> sorted, double share);

/// The share of draws below the lower end of a 95 % interval of `clusters` clusters: 2.5 %, made smaller for the sake
/// of small samples by the factor sqrt(n / (n - 1)) and Student's t. Source: Hesterberg 2015, "What teachers should
/// know about the bootstrap", The American Statistician 69, "expanded percentile".
double expanded_tail(int clusters);

/// The bootstrap interval of the mean of values in [0, 1], clustered: whole homes are drawn, since tasks of one home,
/// and repeats of one task, resemble each other. [0, 1] for fewer than two clusters. Where all clusters have mean 0, or
/// all have mean 1, nothing varies between draws; the interval is then Wilson's, each cluster one trial.
Interval bootstrap_interval(std::span<const ClusterSum> clusters, Rng rng, int draws = 2000);

}  // namespace unietp
