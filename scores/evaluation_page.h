#pragma once

#include <span>
#include <string>

#include "scores/result_table.h"
#include "scores/scored_run.h"

namespace unietp {

/// A page of one run: its tables, a chart of the failures by split, a list of its episodes, and a viewer that plays
/// them, which opens the pages of report_pages.h. Each count of a table leads to its episodes.
std::string evaluation_page(const ScoredRun& run);

/// A self-contained page of several runs side by side: ranks first, then all tables. Each count leads to its episodes
/// in the run's report. `reports`: the URL of each run's, as seen from the page; "" for none.
std::string leaderboard_page(std::span<const ScoredRun> runs, std::span<const std::string> reports);

}  // namespace unietp
