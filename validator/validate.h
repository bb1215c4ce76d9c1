#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "core/error.h"
#include "simulation/profile.h"

namespace unietp {

/// Something wrong with a data set: with one task, or (task "") with the folder as a whole.
struct Problem {
  std::string task;
  Error error;  // file, line where there is one, and why
  bool operator==(const Problem&) const = default;
};

struct ValidationReport {
  int tasks = 0, proven = 0;
  std::vector<Problem> problems;  // folder-wide ones first, then in the order of tasks.jsonl
  bool sound() const { return problems.empty() && proven == tasks; }
};

/// Facts and limits of one simulator, as physics needs them to rebuild its scenes.
struct ValidationBackend {
  const Knowledge* knowledge = nullptr;
  const Profile* profile = nullptr;
};

struct ValidationOptions {
  int threads = 1;
  double rest_m = 0.005;  // a body that moves farther than this when physics runs on was not at rest
};

/// Proves a finished data set from its files: checksums; each task, scene and demonstration read strictly; the start
/// scene rebuilt in fresh physics, its relations as recorded and at rest; the goal's text and tree the same formula,
/// false at the start, no quantifier over nothing; each demonstration replayed step by step with the same outcomes,
/// views and changes; the goal true on the replayed trace by the direct evaluator; and an instruction. Reports all
/// problems. Shares no code with the stages that made the data set. Deterministic for any number of threads.
/// `backends` are in the order of kSimulators; `knowledge_digest` is compared with the manifest's.
ValidationReport validate_dataset(const std::filesystem::path& folder, const std::vector<ValidationBackend>& backends,
                                  std::string_view knowledge_digest, const ValidationOptions& options);

}  // namespace unietp
