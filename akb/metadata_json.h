#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "akb/csv.h"
#include "core/result.h"

namespace unietp {

/// A simulator's JSON file, gzipped or not. Errors: Io; Parse with line and column.
Result<nlohmann::json> read_metadata_json(const std::filesystem::path& path);
/// A simulator's CSV file, gzipped or not. Errors: Io; the first Parse error.
Result<CsvFile> read_metadata_csv(const std::filesystem::path& path);

}  // namespace unietp
