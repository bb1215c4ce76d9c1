#include "scores/pass_rates.h"

namespace unietp {

double pass_all(int n, int c, int k) {
  double share = 1;
  for (int i = 0; i < k; ++i) share *= c <= i ? 0 : static_cast<double>(c - i) / (n - i);
  return share;
}

double pass_at(int n, int c, int k) { return 1 - pass_all(n, n - c, k); }

}  // namespace unietp
