#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/sqlite_file.h"
#include "pipeline/candidate.h"

namespace unietp {

/// What a run has found so far, in one SQLite file that survives a kill: each candidate is one transaction. Not
/// thread-safe. Every function may fail with Io, saying what SQLite said.
class Ledger {
 public:
  /// Opens or makes the file. `identity` names the run (version, knowledge, configuration, seed): a file of another run
  /// is refused (Usage) with both named.
  static Result<Ledger> open(const std::filesystem::path& path, const std::string& identity);

  Result<Done> add(const CandidateRecord& record);

  /// All candidates in order of (attempt, slot), without their texts: only slot, attempt, accepted, template, keys and
  /// traits.
  Result<std::vector<CandidateRecord>> outlines();
  /// One candidate, whole. Errors: Io also when there is none.
  Result<CandidateRecord> read(int slot, int attempt);

 private:
  explicit Ledger(SqliteFile file) : file_(std::move(file)) {}
  SqliteFile file_;
};

}  // namespace unietp
