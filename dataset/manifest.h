#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "dataset/dataset_counts.h"
#include "resources/resources.h"

namespace unietp {

/// A source of facts behind a data set.
struct SourceLicence {
  std::string source;   // "metadata:ai2thor/object_types.json", "curated"
  std::string origin;   // repository it was collected from
  std::string licence;  // as found there
};

/// The sources that the facts of the configuration's simulators name, sorted, with what the table says of each.
/// Errors: Io, Parse; Schema when a metadata source has no row (a licence is never guessed).
Result<std::vector<SourceLicence>> sources_of(const RunConfiguration& configuration, const Resources& resources,
                                              const std::filesystem::path& table);

/// Text of manifest.json for a folder whose other files are all written. Errors: Io.
Result<std::string> manifest_of(const std::filesystem::path& folder, const RunConfiguration& configuration,
                                const Resources& resources, const DatasetCounts& counts,
                                const std::vector<SourceLicence>& sources);

/// "0.1.0"
std::string_view program_version();

}  // namespace unietp
