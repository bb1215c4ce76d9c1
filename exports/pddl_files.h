#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "exports/task_folder.h"
#include "validator/validation_options.h"

namespace unietp {

/// Writes a data set's tasks as PDDL: `<simulator>/domain.pddl`, `<simulator>/<task>.pddl`, the demonstration as a plan
/// of it, `<simulator>/<task>.plan`, and `left_out.jsonl` with each task that PDDL does not say and why. The folder
/// `out` must not exist; it appears as a whole at the end. Errors: those of reading the data set, Io, Usage for a
/// folder that is there.
Result<ExportedTasks> export_pddl(const std::filesystem::path& dataset, const std::vector<ValidationBackend>& backends,
                                  const std::filesystem::path& out);

}  // namespace unietp
