#include "audit/tail.h"

#include <algorithm>
#include <cstddef>

namespace unietp {

double chance_of_at_least(int hits, const std::vector<double>& chances) {
  if (hits <= 0) return 1;
  std::vector<double> exactly(static_cast<std::size_t>(hits), 0.0);  // so many successes so far, each below `hits`
  exactly[0] = 1;
  double reached = 0;
  for (const double chance : chances) {
    reached += exactly.back() * chance;
    for (std::size_t k = exactly.size(); k-- > 1;) exactly[k] += chance * (exactly[k - 1] - exactly[k]);
    exactly[0] *= 1 - chance;
  }
  return std::min(1.0, reached);
}

}  // namespace unietp
