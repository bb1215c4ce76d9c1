#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "dataset/configuration.h"

namespace unietp {

/// A run's configuration as in manifests and configuration files (docs/files.md); configuration_from_json reads it
/// back.
nlohmann::ordered_json to_json(const RunConfiguration& configuration);

/// The text of a configuration file: `{"format": "unietp-run/1", "seed": 1, …}`; missing fields have their defaults.
/// Errors: Parse with line and column; Schema with a JSON pointer for an unknown or mistyped field, a name that is none
/// (with the nearest one), a number out of its range, quotas of which the sums differ.
Result<RunConfiguration> configuration_from_json(std::string_view where, std::string_view text);

/// As above, of a file. Errors: also Io.
Result<RunConfiguration> read_configuration(const std::filesystem::path& file);

}  // namespace unietp
