#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/result.h"
#include "core/sqlite_file.h"
#include "llm/exchange.h"

namespace unietp {

/// Answers of language models in a SQLite file, by the digest of their request. A stored answer survives a kill of the
/// process. Several processes may use one file; one value is for one thread.
class LlmCache {
 public:
  /// Makes the file, and its folder, when it is not there. Errors: Io, also when the file is something else.
  static Result<LlmCache> open(const std::filesystem::path& path);

  /// The answer, marked as cached; nothing when there is none.
  std::optional<LlmAnswer> find(const std::string& digest);
  /// Stores an answer; an existing one of the digest is kept.
  void store(const std::string& digest, const std::string& model, const LlmAnswer& answer);
  /// The first failure of find or store (a full disk, say). Answers still arrive, but may be requested again.
  const std::optional<Error>& failure() const { return failure_; }

 private:
  LlmCache(std::filesystem::path path, SqliteFile file) : path_(std::move(path)), file_(std::move(file)) {}
  void record_failure(const std::exception& exception);

  std::filesystem::path path_;
  SqliteFile file_;
  std::optional<Error> failure_;
};

}  // namespace unietp
