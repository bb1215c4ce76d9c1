#pragma once

#include <filesystem>

#include "exports/task_folder.h"

namespace unietp {

/// Writes the start scene of each task whole, `<scene>.scene.json.gz`, for readers that would rather not put a home and
/// its changes together. The folder `out` must not exist; it appears as a whole at the end. Errors: those of reading
/// the data set, Io, Usage for a folder that is there.
Result<ExportedTasks> export_starts(const std::filesystem::path& dataset, const std::filesystem::path& out);

}  // namespace unietp
