#pragma once

#include <filesystem>

#include "core/result.h"
#include "record/manifest_record.h"
#include "resources/resources.h"
#include "validator/validation_options.h"

namespace unietp {

/// What the writer of a data set with this manifest puts into README.md and into the manifest's sources, for the
/// validator. `licenses`: the table of sources. Errors: Schema for a configuration or a source that is not known; those
/// of sources_of.
Result<DerivedFiles> expected_files(const ManifestRecord& manifest, const Resources& resources,
                                    const std::filesystem::path& licenses);

}  // namespace unietp
