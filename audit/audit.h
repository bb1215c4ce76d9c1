#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "audit/guess.h"
#include "audit/policies.h"
#include "core/result.h"

namespace unietp {

/// Below this chance of any false finding in a whole audit, a finding counts.
inline constexpr double kAuditLevel = 0.05;

/// How a policy does on some tasks of one mode.
struct AuditCell {
  const ShortcutPolicy* policy = nullptr;
  Mode mode = Mode::M1;
  std::string group;         // "all", a split or a simulator
  int asked = 0;             // questions
  int right = 0;             // guesses that were right
  double chance = 0;         // mean share of right guesses over the permutations
  double low = 0, high = 1;  // that share in all but the lowest and highest 2.5 % of the permutations
  double p = 1;              // probability of so many right guesses by chance, corrected for the number of cells (Holm)
  bool leaks() const { return p < kAuditLevel; }
};

/// What the policies reach on a data set.
struct AuditReport {
  int tasks = 0, homes = 0;
  int examples = 0;              // tasks of the training set; 0: without, the other homes of the set were learned from
  std::vector<AuditCell> cells;  // in the order of the policies, modes and groups; those with questions only
  int leaks() const;
};

/// The tasks of a finished data set as the policies see them; `progress` is called with the number of tasks read.
/// Errors: those of DatasetReader; Schema for a set without tasks.
Result<std::vector<AuditedTask>> audited_tasks(const std::filesystem::path& folder, int threads,
                                               const std::function<void(int)>& progress);

/// How an audit is done.
struct AuditSettings {
  int threads = 1;
  std::vector<const ShortcutPolicy*> policies;  // to play; of shortcut_policies()
  std::function<void(int)> progress;            // told how many questions were played; from any thread
};
/// All policies, on one thread, told to nobody.
AuditSettings whole_audit();

/// Plays policies. `training`: tasks to learn from; empty: those of the other homes. The chance of success in each
/// question is its share of right guesses over the permutations and the question as it is; the probability of a cell is
/// the exact one of a sum of independent trials with these chances, because a thousand permutations cannot show the
/// small probabilities that a correction for hundreds of cells asks for. Equal tasks give equal reports, with any
/// number of threads.
AuditReport audit(std::vector<AuditedTask> tasks, std::vector<AuditedTask> training, const AuditSettings& settings);

/// A table: for each policy and mode the line of all tasks, and lines of splits and simulators that leak; `whole`: all.
std::string audit_table(const AuditReport& report, bool whole);
/// All cells as JSON, with a line feed at the end.
std::string audit_json(const AuditReport& report);

}  // namespace unietp
