#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "record/manifest_record.h"
#include "validator/problem_list.h"
#include "validator/validation_options.h"

namespace unietp {

/// Compares the files in homes/ with what they must be, byte for byte once unpacked: the home that the configuration
/// gives under this name, made again by `make`, or the one that it was given, by its SHA-256. `used`: the names of the
/// homes that tasks are in; each must have a file, and no other has one. Without `make` only given homes are compared.
ProblemList check_homes(const std::filesystem::path& folder, const ManifestRecord& manifest,
                        const std::vector<std::string>& used, const MakeHome& make, int threads);

}  // namespace unietp
