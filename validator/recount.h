#pragma once

#include <vector>

#include "record/manifest_record.h"
#include "validator/database_check.h"
#include "validator/folder_reading.h"
#include "validator/problem.h"

namespace unietp {

/// The manifest's numbers of tasks and rejections against those of the lines; each rejection a candidate of its own.
std::vector<Problem> recount_tasks(const ManifestRecord& manifest, const FolderReading& set);
std::vector<Problem> recount_rejections(const ManifestRecord& manifest, const FolderReading& set);

/// The tasks against what the recorded configuration asks for: their number, quotas by split and by simulator, modes,
/// templates, homes.
std::vector<Problem> check_quotas(const RecordedRun& run, const FolderReading& set);

/// The recorded spread over each dimension against that of the tasks.
std::vector<Problem> check_balance(const ManifestRecord& manifest, ValueCounts counts);

}  // namespace unietp
