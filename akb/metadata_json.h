#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "akb/csv.h"
#include "core/result.h"

namespace unietp {

/// A simulator's JSON file, gzipped or not. Errors: Io; Parse with line and column.
Result<nlohmann::json> read_metadata_json(const std::filesystem::path& path);
/// A simulator's CSV file, gzipped or not. Errors: Io; the first Parse error.
Result<CsvFile> read_metadata_csv(const std::filesystem::path& path);

/// A small table of names: what its second column says, by the name in the first.
using NameTexts = std::map<std::string, std::string>;
/// Errors: Io; the first Parse error; Schema for a row with fewer than two cells or a name that stands twice.
Result<NameTexts> read_name_texts(const std::filesystem::path& path);

}  // namespace unietp
