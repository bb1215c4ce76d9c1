#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/result.h"

namespace unietp {

/// The SHA-256 of each home of the benchmark as JSON, by name: who knows it need not make the home again to compare
/// it.
using KnownHomes = std::map<std::string, std::string>;

/// Reads `<folder>/benchmark-homes.csv`, with the columns home and sha256. Errors: Io; Parse and Schema with line and
/// column.
Result<KnownHomes> read_known_homes(const std::filesystem::path& folder);

}  // namespace unietp
