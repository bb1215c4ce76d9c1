#pragma once

#include <cstdint>
#include <vector>

#include "audit/guess.h"

namespace unietp {

/// Homes are shared out in so many parts by their names; what is asked about a home of one part is learned from the
/// homes of the others.
inline constexpr std::size_t kHomeParts = 5;
std::size_t part_of(const AuditedTask& task);

/// Fills in what instructions by themselves suggest about which of several things of a kind the task is about:
/// `expected_rank` and `expected_place` are the mean number_rank and place of what the most similar instruction means
/// in another home (most shared words in relation to all words of both; of equals, the first), `text_rank` is the
/// number_rank that a linear model of words and pairs of words predicts. 0.5 without examples.
void learn_from_texts(std::vector<AuditedTask>& tasks, const std::vector<AuditedTask>& examples);

}  // namespace unietp
