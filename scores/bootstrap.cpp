#include "scores/bootstrap.h"

#include <algorithm>
#include <iterator>

namespace unietp {

std::vector<double> bootstrap_rates(std::span<const ClusterCount> clusters, Rng rng, int draws) {
  std::vector<ClusterCount> used;
  std::ranges::copy_if(clusters, std::back_inserter(used), [](const ClusterCount& one) { return one.episodes > 0; });
  std::vector<double> rates;
  if (used.empty()) return rates;
  rates.reserve(static_cast<std::size_t>(draws));
  for (int draw = 0; draw < draws; ++draw) {
    ClusterCount total;
    for (std::size_t i = 0; i < used.size(); ++i) {
      const ClusterCount& one = used[rng.below(used.size())];
      total.successes += one.successes;
      total.episodes += one.episodes;
    }
    rates.push_back(total.successes / static_cast<double>(total.episodes));
  }
  std::sort(rates.begin(), rates.end());
  return rates;
}

double quantile_of(std::span<const double> sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Interval bootstrap_interval(std::span<const ClusterCount> clusters, Rng rng) {
  const auto rates = bootstrap_rates(clusters, rng, 2000);
  if (rates.empty()) return {};
  return {quantile_of(rates, 0.025), quantile_of(rates, 0.975)};
}

}  // namespace unietp
