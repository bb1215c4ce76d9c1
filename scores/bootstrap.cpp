#include "scores/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "scores/normal.h"

namespace unietp {
namespace {

/// The 97.5 % quantile of Student's t, by the Cornish-Fisher expansion (Abramowitz and Stegun 26.7.5): to 1e-3 from 4
/// degrees of freedom on.
double student_975(double freedom) {
  const double z = kNormal975, z2 = z * z, f = freedom;
  return z + z * (z2 + 1) / (4 * f) + z * ((5 * z2 + 16) * z2 + 3) / (96 * f * f) +
         z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / (384 * f * f * f);
}

}  // namespace

std::vector<double> bootstrap_means(std::span<const ClusterSum> clusters, Rng rng, int draws) {
  std::vector<double> means;
  if (clusters.empty()) return means;
  means.reserve(static_cast<std::size_t>(draws));
  for (int draw = 0; draw < draws; ++draw) {
    ClusterSum total;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      const ClusterSum& one = clusters[rng.below(clusters.size())];
      total.sum += one.sum;
      total.count += one.count;
    }
    means.push_back(total.count > 0 ? total.sum / total.count : 0);
  }
  std::sort(means.begin(), means.end());
  return means;
}

double quantile_of(std::span<const double> sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

double expanded_tail(int clusters) {
  const double n = clusters;
  return normal_share_below(-std::sqrt(n / (n - 1)) * student_975(n - 1));
}

Interval bootstrap_interval(std::span<const ClusterSum> clusters, Rng rng, int draws) {
  std::vector<ClusterSum> used;
  for (const ClusterSum& one : clusters) {
    if (one.count > 0) used.push_back(one);
  }
  if (used.size() < 2) return {};
  const auto all_are = [&](bool good) {
    return std::all_of(used.begin(), used.end(), [&](const ClusterSum& c) { return c.sum == (good ? c.count : 0); });
  };
  const int homes = static_cast<int>(used.size());
  if (all_are(false) || all_are(true)) return wilson_interval(all_are(true) ? homes : 0, homes);
  const auto means = bootstrap_means(used, rng, draws);
  const double tail = expanded_tail(homes);
  return {quantile_of(means, tail), quantile_of(means, 1 - tail)};
}

}  // namespace unietp
