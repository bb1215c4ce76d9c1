#pragma once

#include <span>

#include "scores/interval.h"

namespace unietp {

/// The episodes of one home.
struct ClusterCount {
  int successes = 0, episodes = 0;
  bool operator==(const ClusterCount&) const = default;
};

/// The 95 % interval of the success rate of homes like those of the clusters, each home with a rate of its own around
/// it. Beta-binomial: rates of homes have a beta distribution whose mean is the success rate and whose spread is given
/// by the correlation of two episodes of one home. The success rate has Jeffreys' prior, beta(1/2, 1/2); the
/// correlation is 0 with a quarter of the prior, and otherwise uniform in [0, 1], taken at (i / 20)², i = 1 … 19. The
/// interval lies between the 2.5 and 97.5 % quantiles of the posterior, over 400 rates with equal steps of
/// arcsine(√rate), interpolated. 0 is its lower end without a success, 1 its upper end without a failure. [0, 1] for
/// fewer than two clusters with episodes, which say nothing of how homes differ. Deterministic, whatever the order of
/// the clusters. docs/results.md says how often it covers the true rate. Source of the model: Williams 1975, "The
/// analysis of binary responses from toxicological experiments involving reproduction and teratogenicity", Biometrics
/// 31; of the prior for the rate: Brown, Cai and DasGupta 2001, "Interval estimation for a binomial proportion",
/// Statistical Science 16.
Interval clustered_interval(std::span<const ClusterCount> clusters);

}  // namespace unietp
