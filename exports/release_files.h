#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "validator/validation_options.h"

namespace unietp {

struct ReleaseExport {
  std::size_t tasks = 0, left_out = 0;
  std::size_t with_scene = 0;  // of the tasks: whose scene their runner can load as the record says it
};

/// Writes a data set as the paper's authors released theirs: THOR.json, VH.json, Hab.json and BEHAVIOR.json, each a
/// list of tasks that their runner reads; files that belong to scenes; `left_out.jsonl` with each task that is not
/// there and why, and `scenes.jsonl` with what of each scene is not said. `out` must not exist; it appears as a whole
/// at the end. Deterministic. Errors: those of reading the data set, Io, Usage for a folder that is there.
Result<ReleaseExport> export_release(const std::filesystem::path& dataset,
                                     const std::vector<ValidationBackend>& backends, const std::filesystem::path& out);

}  // namespace unietp
