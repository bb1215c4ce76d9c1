#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "akb/knowledge.h"
#include "scene/simulator.h"
#include "simulation/profile.h"
#include "validator/problem.h"
#include "validator/stated_goal.h"

namespace unietp {

/// What was proven how often.
struct ProofCounts {
  int tasks = 0, proven = 0;
  int demonstrations = 0, steps = 0;  // replayed
  int spoilt_plans = 0;               // that must fail
  int texts = 0;                      // read
};

struct ValidationReport {
  ProofCounts counts;
  std::array<ProofCounts, kSimulators.size()> by_simulator;  // in the order of kSimulators
  std::vector<Problem> problems;                             // folder-wide ones first, then in the order of tasks.jsonl
  bool sound() const { return problems.empty() && counts.proven == counts.tasks; }
};

/// Facts and limits of one simulator, as physics needs them to rebuild its scenes.
struct ValidationBackend {
  const Knowledge* knowledge = nullptr;
  const Profile* profile = nullptr;
};

struct ValidationOptions {
  int threads = 1;
  double rest_m = 0.005;  // a body that moves farther than this when physics runs on was not at rest
  TextCheck check_text;   // none: instructions are not read
  std::vector<std::filesystem::path> against;  // finished data sets with which no home, seed or text may be shared
};

/// Proves a finished data set from its files: docs/validate.md says what and how. Reports all problems. Shares no code
/// with the stages that made the data set. Deterministic for any number of threads. `backends` are in the order of
/// kSimulators; `knowledge_digest` is compared with the manifest's.
ValidationReport validate_dataset(const std::filesystem::path& folder, const std::vector<ValidationBackend>& backends,
                                  std::string_view knowledge_digest, const ValidationOptions& options);

}  // namespace unietp
