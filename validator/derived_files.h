#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "record/manifest_record.h"
#include "validator/problem.h"
#include "validator/validation_options.h"

namespace unietp {

/// Compares README.md, the manifest's sources and the name of its benchmark with what `derive` makes of the manifest;
/// nothing without it.
std::vector<Problem> check_derived_files(const std::filesystem::path& folder, const ManifestRecord& manifest,
                                         const DeriveFiles& derive);

/// What a line of a card says besides prose: the whole line where it is of a table, a list, a title or the metadata;
/// otherwise its numbers and its words in backquotes.
std::string facts_of_line(std::string_view line);

}  // namespace unietp
