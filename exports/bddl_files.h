#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "exports/task_folder.h"
#include "validator/validation_options.h"

namespace unietp {

/// Writes BEHAVIOR's tasks as BDDL, `<task>.bddl` each, and `left_out.jsonl` with each task that BDDL does not say and
/// why. `synsets`: data/bddl/synsets.csv. `out` must not exist; it appears as a whole at the end. Errors: those of
/// reading the data set, Io, Usage for a folder that is there.
Result<ExportedTasks> export_bddl(const std::filesystem::path& dataset, const std::vector<ValidationBackend>& backends,
                                  const std::filesystem::path& synsets, const std::filesystem::path& out);

}  // namespace unietp
