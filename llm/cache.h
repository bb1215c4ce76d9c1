#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/result.h"
#include "core/sqlite_file.h"
#include "llm/exchange.h"

namespace unietp {

/// Answers of language models in a SQLite file, by the digest of what shaped them. An answer that was kept survives a
/// kill of the process. Several processes may use one file; one value is for one thread.
class LlmCache {
 public:
  /// Makes the file, and its folder, when it is not there. Errors: Io, also when the file is something else.
  static Result<LlmCache> open(const std::filesystem::path& path);

  /// The answer, marked as cached; nothing when there is none.
  std::optional<LlmAnswer> find(const std::string& digest);
  /// Keeps an answer; a digest that is there keeps its first.
  void keep(const std::string& digest, const std::string& model, const LlmAnswer& answer);
  /// The first failure of find or keep (a full disk, say). Answers then still arrive, but may be asked again.
  const std::optional<Error>& trouble() const { return trouble_; }

 private:
  LlmCache(std::filesystem::path path, SqliteFile file) : path_(std::move(path)), file_(std::move(file)) {}
  void note(const std::exception& failure);

  std::filesystem::path path_;
  SqliteFile file_;
  std::optional<Error> trouble_;
};

}  // namespace unietp
