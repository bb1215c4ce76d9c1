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

/// The 97.5 % quantile of Student's t: to 1e-3 from 4 degrees of freedom on.
double student_975(double freedom);

/// The 95 % interval of the mean of values in [0, 1], clustered: whole homes are drawn, since tasks of one home, and
/// repeats of one task, resemble each other. The variance of the draws says how many independent trials the values are
/// worth, at most as many as there are; the interval is Wilson's of as many, with Student's t in the place of the
/// normal quantile. Where all clusters have mean 0, or all have mean 1, nothing varies between draws and each cluster
/// is one trial. [0, 1] for fewer than two clusters.
/// Percentiles of the draws cover rare successes in few homes too seldom; docs/results.md says how often these do.
/// Source: Dean and Pagano 2015, "Evaluating confidence interval methods for binomial proportions in
/// clustered surveys", Journal of Survey Statistics and Methodology 3, "Wilson", with the variance of a bootstrap.
Interval bootstrap_interval(std::span<const ClusterSum> clusters, Rng rng, int draws = 2000);

}  // namespace unietp
