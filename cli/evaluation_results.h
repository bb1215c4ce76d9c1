#pragma once

#include <filesystem>

#include "cli/commands.h"
#include "environment/task_source.h"
#include "scores/watched_episodes.h"

namespace unietp {

/// What judging episodes on these tasks needs, which must outlive it. Errors: Io.
Result<JudgingData> judging_data(const TaskSource& tasks, const CommandLine& program);

/// Scores a finished or incomplete evaluation and writes its results (scores/write_results.h); prints its tables.
Exit write_and_print_results(const std::filesystem::path& folder, const JudgingData& judging,
                             const WatchedEpisodes& watched, int threads);

/// Whether a folder is that of an evaluation, by the format of its manifest.
bool is_evaluation(const std::filesystem::path& folder);

/// `unietp validate` for an evaluation: prints each problem and what was checked. `dataset`: what it was made on, whose
/// digest must be the manifest's.
Exit validate_evaluation(const std::filesystem::path& folder, const std::filesystem::path& dataset, int threads,
                         const CommandLine& program);

}  // namespace unietp
