#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/result.h"

namespace unietp {

/// SHA-256 of what an agent acts in: over the name and the SHA-256 of tasks.jsonl and of every home, in order of name.
/// Whatever else a data set holds (demonstrations, manifest, database) has no part in it. `files`: SHA-256 of a data
/// set's files by path, as its manifest lists them.
std::string dataset_digest(const std::map<std::string, std::string>& files);

/// The same of a folder, from its files. Errors: Io.
Result<std::string> dataset_digest(const std::filesystem::path& folder);

/// The benchmarks that never change again.
class FrozenBenchmarks {
 public:
  /// Reads data/benchmarks.csv ("name,digest"). Errors: Io; Parse with line.
  static Result<FrozenBenchmarks> read(const std::filesystem::path& table);

  /// The name of the benchmark with this digest, or "".
  std::string name_of(const std::string& digest) const;

 private:
  std::map<std::string, std::string> names_;  // by digest
};

}  // namespace unietp
