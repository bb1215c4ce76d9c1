#pragma once

#include <map>
#include <span>
#include <string>

#include "scores/scored_run.h"

namespace unietp {

/// The figures of one run as JSON (data/schemas/results.schema.json). `manifest_digest`: SHA-256 of its manifest.json.
std::string results_json(const ScoredRun& run, const std::string& manifest_digest);

/// The success rates in the form of the results of lm-evaluation-harness, a task for each mode and each split of it.
std::string lm_eval_json(const ScoredRun& run);

/// The text of each file that a finished evaluation adds to its folder, but for the report: scores.jsonl, results.json,
/// lm_eval.json, tables.md, tables.tex, tables.csv. Equal runs give equal bytes.
std::map<std::string, std::string> result_files(const ScoredRun& run, const std::string& manifest_digest);

}  // namespace unietp
