#pragma once

#include <vector>

namespace unietp {

/// The probability of at least `hits` successes in independent trials, each with its own chance of success. Exact up
/// to rounding of about 1e-13, in time of the number of trials times `hits`: the sum of independent trials is counted
/// one trial after the other.
double chance_of_at_least(int hits, const std::vector<double>& chances);

}  // namespace unietp
