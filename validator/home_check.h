#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "record/manifest_record.h"
#include "validator/problem_list.h"
#include "validator/validation_options.h"

namespace unietp {

/// Compares the files in homes/ with what they must be, byte for byte once unpacked: the home that the configuration
/// gives under this name, by its SHA-256 where that is known or else made again, or the one that the run was given, by
/// its SHA-256. `used`: the names of the homes that tasks are in; no other has a file. Takes `known_homes`, `make_home`
/// (without which homes of other names are not compared) and the threads of the options.
ProblemList check_homes(const std::filesystem::path& folder, const ManifestRecord& manifest,
                        const std::vector<std::string>& used, const ValidationOptions& options);

}  // namespace unietp
