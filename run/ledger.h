#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/sqlite_file.h"
#include "dataset/candidate.h"
#include "run/stage_costs.h"

namespace unietp {

/// The candidates and homes of a run so far, in one SQLite file that survives a kill: each candidate is one
/// transaction. Safe to use from several threads, except to move. Every function may fail with Io and SQLite's message.
class Ledger {
 public:
  /// Opens or makes the file. `identity` names the run (version, knowledge, configuration, seed): a file of another run
  /// is refused (Usage) with both named.
  static Result<Ledger> open(const std::filesystem::path& path, const std::string& identity);
  /// Opens a file that `copy_to` made, to read only. Errors: also Usage when it is of another run.
  static Result<Ledger> read_only(const std::filesystem::path& path, const std::string& identity);
  /// Whether a ledger may be written to `path`: there is nothing, or another ledger. Errors: Usage.
  static Result<Done> check_replaceable(const std::filesystem::path& path);
  /// Writes everything to one new file, in order of slot and attempt. Costs differ between equal runs, so they are left
  /// out unless asked for.
  Result<Done> copy_to(const std::filesystem::path& path, bool with_costs = false);

  /// Adds a candidate. `costs`: the time spent on it.
  Result<Done> add(const CandidateRecord& record, const StageCosts& costs);

  /// Keeps the packed scene of a home unless it has it already.
  Result<Done> keep_home(const std::string& layout, const std::function<std::string()>& packed);
  /// The packed scene of a home. Errors: Io also when there is none.
  Result<std::string> home(const std::string& layout);

  /// The candidates of `slots` slots from `first` on, in order of (attempt, slot), as outlines.
  Result<std::vector<CandidateRecord>> outlines(int first, int slots);
  /// One candidate, whole. Errors: Io also when there is none.
  Result<CandidateRecord> read(int slot, int attempt);

 private:
  explicit Ledger(SqliteFile file) : file_(std::move(file)), mutex_(std::make_unique<std::mutex>()) {}
  SqliteFile file_;
  std::unique_ptr<std::mutex> mutex_;
};

}  // namespace unietp
