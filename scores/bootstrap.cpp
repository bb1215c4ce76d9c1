#include "scores/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "scores/normal.h"

namespace unietp {
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

double student_975(double freedom) {
  // The Cornish-Fisher expansion (Abramowitz and Stegun 26.7.5).
  const double z = kNormal975, z2 = z * z, f = freedom;
  return z + z * (z2 + 1) / (4 * f) + z * ((5 * z2 + 16) * z2 + 3) / (96 * f * f) +
         z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / (384 * f * f * f);
}

Interval bootstrap_interval(std::span<const ClusterSum> clusters, Rng rng, int draws) {
  std::vector<ClusterSum> used;
  ClusterSum all;
  for (const ClusterSum& one : clusters) {
    if (one.count <= 0) continue;
    used.push_back(one);
    all = {all.sum + one.sum, all.count + one.count};
  }
  if (used.size() < 2) return {};
  const auto homes = static_cast<double>(used.size());
  const double mean = all.sum / all.count, quantile = student_975(homes - 1);
  double trials = homes;
  if (mean > 0 && mean < 1) {
    double squares = 0;
    for (const double drawn : bootstrap_means(used, rng, draws)) squares += (drawn - mean) * (drawn - mean);
    const double variance = squares / draws * homes / (homes - 1);  // draws of n vary by (n - 1) / n of it
    trials = std::min(all.count, variance > 0 ? mean * (1 - mean) / variance : all.count);
  }
  return wilson_interval(mean, trials, quantile);
}

}  // namespace unietp
