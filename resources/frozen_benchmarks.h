#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace unietp {

/// SHA-256 of what an agent acts in: over the name and the SHA-256 of tasks.jsonl and of every home, in order of name.
/// Whatever else a data set holds (demonstrations, manifest, database) has no part in it. Errors: Io.
Result<std::string> dataset_digest(const std::filesystem::path& folder);

/// The name of the frozen benchmark with this digest in data/benchmarks.csv ("name,digest"), or "". Errors: Io; Parse.
Result<std::string> benchmark_version(const std::filesystem::path& table, const std::string& digest);

}  // namespace unietp
