#pragma once

namespace unietp {

/// pass@k: the probability that at least one of k repeats drawn from n, of which c succeeded, is among the successes:
/// 1 - C(n - c, k) / C(n, k). 1 <= k <= n, 0 <= c <= n. Source: Chen and others 2021, "Evaluating large language models
/// trained on code", equation 1.
double pass_at(int n, int c, int k);

/// pass^k: the probability that all of k repeats drawn from n succeeded: C(c, k) / C(n, k). Source: Yao and others
/// 2024, "tau-bench", section 3.
double pass_all(int n, int c, int k);

}  // namespace unietp
