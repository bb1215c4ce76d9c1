#pragma once

#include <filesystem>

#include "core/error.h"
#include "scores/scored_run.h"

namespace unietp {

inline constexpr const char* kReportFile = "report.html";  // in the folder of results

/// Scores the episodes of a folder that has a manifest, and writes into it scores.jsonl, results.json, lm_eval.json,
/// tables.md, tables.tex, tables.csv, report.html and the folder report, with pictures of
/// as many episodes as the manifest allows, spread over modes, splits and results. Deterministic for any number of
/// threads. Errors: those of score_run; Schema, naming file, line and field, for an episode that does not agree with
/// its replies; Io.
Result<ScoredRun> write_results(const std::filesystem::path& folder, const ScoringData& data);

/// Every way in which the folder of an evaluation is not what its episodes lead to: a file whose digest is not that of
/// the manifest, totals that are not those of the episodes, an episode that does not agree with its replies, a result
/// file whose bytes are not those that follow. Empty when sound. Errors that end the check are the last one.
std::vector<Error> check_results(const std::filesystem::path& folder, const ScoringData& data);

}  // namespace unietp
