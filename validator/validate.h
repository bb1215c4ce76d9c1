#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/simulator.h"
#include "validator/likeness_report.h"
#include "validator/problem_list.h"
#include "validator/proof_counts.h"
#include "validator/validation_options.h"

namespace unietp {

/// What a validation found.
struct ValidationReport {
  ProofCounts counts;
  std::array<ProofCounts, kSimulators.size()> by_simulator;  // in the order of kSimulators
  std::vector<Problem> problems;                             // folder-wide ones first, then in the order of tasks.jsonl
  std::vector<LikenessReport> likeness;                      // to each set of ValidationOptions::against that reads
  std::array<std::int64_t, kProblemKinds> found{};           // of each kind; of one with many, some are not in the list
  /// Every task is proven and nothing else is wrong; with ValidationOptions::accept_unchecked, proven but for texts
  /// that failed the checks.
  bool sound() const { return problems.empty() && counts.proven + counts.unchecked == counts.tasks; }
};

/// Verifies a finished data set, given only its files, as docs/validate.md explains. Reports the first
/// ProblemList::kKept problems of each kind and counts all. Shares no code with the stages that made the data set.
/// Of several parts, which are runs of tasks of about equal length, only the tasks of one are proven and counted. The
/// first part also checks what is of the data set as a whole (files, counts, repeats, homes, what is shared with other
/// sets), so that all parts together find what one call for all tasks finds.
/// Memory: some tasks at a time, and of each task that is proven, in the first part of each task, what docs/validate.md
/// states.
/// Deterministic for any number of threads. `backends` are in the order of kSimulators; `knowledge_digest` is compared
/// with the manifest's.
ValidationReport validate_dataset(const std::filesystem::path& folder, const std::vector<ValidationBackend>& backends,
                                  std::string_view knowledge_digest, const ValidationOptions& options);

}  // namespace unietp
