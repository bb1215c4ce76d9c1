#pragma once

#include <span>
#include <string>
#include <vector>

#include "scores/result_table.h"
#include "scores/scored_run.h"

namespace unietp {

/// A split of the benchmark with its column's head, in the order of the paper's main table.
struct SplitColumn {
  std::string_view split, head;
};
std::span<const SplitColumn> split_columns();

/// What to call each run in a table: its agent, with the folder's name where several have the same agent.
std::vector<std::string> labels_of(std::span<const ScoredRun> runs);

/// "Benchmark unietp-1.0, backend unietp, preset paper." and, where it is so, what is incomplete. Of runs on the same
/// data set.
std::string conditions_of(std::span<const ScoredRun> runs);

/// All tables of one run, or of several side by side, in the order of the report. Ids: "main", "m3", "simulators",
/// "feedback", "templates", "behaviour", "boxes", "cost", "repeats", "steps-M1"…, "failures". A table that the runs
/// have nothing for is left out. Deterministic.
std::vector<ResultTable> result_tables(std::span<const ScoredRun> runs);

}  // namespace unietp
