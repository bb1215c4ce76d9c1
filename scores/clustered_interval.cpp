#include "scores/clustered_interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace unietp {
namespace {

constexpr std::size_t kRateSteps = 400, kCorrelations = 20;

/// Of the i-th correlation, (i / 20)²: a quarter that there is none; else about uniform, as these lie the closer the
/// smaller.
double prior_of(std::size_t i) {
  constexpr double kOfNone = 0.25;
  constexpr std::size_t kSum = kCorrelations * (kCorrelations - 1) / 2;
  return i == 0 ? kOfNone : (1 - kOfNone) * static_cast<double>(i) / kSum;
}

/// The rate at a place in [0, 1] of the scale on which Jeffreys' prior is flat.
double rate_at(double place) {
  const double root = std::sin(place * std::numbers::pi / 2);
  return root * root;
}

/// How many clusters have more than k successes, more than k failures and more than k episodes, for each k. The
/// likelihood of counts that are beta-binomial is a product over these.
struct Exceeding {
  std::vector<int> successes, failures, episodes;

  explicit Exceeding(std::span<const ClusterCount> clusters) {
    int most = 0;
    for (const ClusterCount& one : clusters) most = std::max(most, one.episodes);
    for (auto* const counts : {&successes, &failures, &episodes}) counts->assign(static_cast<std::size_t>(most), 0);
    const auto count = [](std::vector<int>& counts, int below) {
      for (int k = 0; k < below; ++k) ++counts[static_cast<std::size_t>(k)];
    };
    for (const ClusterCount& one : clusters) {
      count(successes, one.successes);
      count(failures, one.episodes - one.successes);
      count(episodes, one.episodes);
    }
  }

  /// Of each rate, up to a constant. With a = rate * (1 - correlation) / correlation the factors are a + k; written
  /// times the correlation, they need no division, and what is added cancels.
  std::array<double, kRateSteps> log_likelihoods(const std::array<double, kRateSteps>& rates,
                                                 double correlation) const {
    std::array<double, kRateSteps> sums{};
    double of_all = 0;
    for (std::size_t k = 0; k < episodes.size(); ++k) {
      const double more = static_cast<double>(k) * correlation;
      of_all += episodes[k] * std::log(1 - correlation + more);
      for (std::size_t j = 0; j < kRateSteps; ++j) {
        const double factor = std::log(rates[j] * (1 - correlation) + more);
        sums[j] += successes[k] * factor;
        sums[kRateSteps - 1 - j] += failures[k] * factor;  // whose rate is 1 - rate
      }
    }
    for (double& sum : sums) sum -= of_all;
    return sums;
  }
};

}  // namespace

Interval clustered_interval(std::span<const ClusterCount> clusters) {
  if (std::ranges::count_if(clusters, [](const ClusterCount& one) { return one.episodes > 0; }) < 2) return {};
  const Exceeding counts(clusters);
  std::array<double, kRateSteps> rates;
  for (std::size_t j = 0; j < kRateSteps; ++j) rates[j] = rate_at((static_cast<double>(j) + 0.5) / kRateSteps);
  std::array<std::array<double, kRateSteps>, kCorrelations> logs;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kCorrelations; ++i) {
    const double root = static_cast<double>(i) / kCorrelations;
    logs[i] = counts.log_likelihoods(rates, root * root);
    for (double& one : logs[i]) most = std::max(most, one += std::log(prior_of(i)));
  }
  std::array<double, kRateSteps + 1> below{};  // the posterior below the lower edge of each step
  for (std::size_t j = 0; j < kRateSteps; ++j) {
    below[j + 1] = below[j];
    for (const auto& of_correlation : logs) below[j + 1] += std::exp(of_correlation[j] - most);
  }
  const auto quantile = [&](double share) {
    const double wanted = share * below.back();
    const auto above = std::ranges::upper_bound(below, wanted);
    const double step = static_cast<double>(above - below.begin() - 1);
    return rate_at((step + (wanted - above[-1]) / (above[0] - above[-1])) / kRateSteps);
  };
  const bool none = counts.successes[0] == 0, all = counts.failures[0] == 0;
  return {none ? 0 : quantile(0.025), all ? 1 : quantile(0.975)};
}

}  // namespace unietp
