#pragma once

#include <span>
#include <vector>

#include "core/rng.h"

namespace unietp {

// Two-sided tests of whether two runs over the same tasks differ. All are deterministic in their arguments.

/// The exact test of McNemar for single runs: the probability, if the runs are alike, of a split of the tasks that only
/// one of them solves at least as uneven as this one. 1 when there are none. Source: McNemar 1947, Psychometrika 12;
/// the binomial distribution in place of the chi-squared.
double mcnemar_test(int only_first, int only_second);

/// The sign-flip test for repeats: the probability, if the runs are alike, that the sum of the differences is as far
/// from 0 as it is, where each home's difference may have either sign. Exact for at most kExactDifferences that are not
/// 0; otherwise from `draws` random choices of signs, the one observed among them. Source: Fisher 1935, "The design of
/// experiments"; Phipson and Smyth 2010 for the random choice.
double sign_flip_test(std::span<const double> differences, Rng rng, int draws = 20'000);
inline constexpr std::size_t kExactDifferences = 16;

/// The probabilities of several tests, made larger so that the chance of any false finding stays below the level of
/// one. In the order given. Source: Holm 1979, "A simple sequentially rejective multiple test procedure".
std::vector<double> holm(std::vector<double> probabilities);

}  // namespace unietp
