#pragma once

#include <span>
#include <string>
#include <vector>

#include "scores/result_table.h"
#include "scores/scored_run.h"

namespace unietp {

/// A self-contained page of one run: its tables, a chart of the failures by split, and a viewer that plays its
/// episodes. `episodes`: JSON of episode_view, in the order of the run. Each count of a table leads to its episodes.
std::string evaluation_page(const ScoredRun& run, const std::vector<std::string>& episodes);

/// A self-contained page of several runs side by side: ranks first, then all tables.
std::string leaderboard_page(std::span<const ScoredRun> runs);

}  // namespace unietp
