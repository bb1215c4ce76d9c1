#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exports/finished_tasks.h"
#include "exports/formats.h"
#include "interchange/habitat_assets.h"

namespace unietp {

/// A task in the form of its simulator.
struct ExpressedTask {
  std::vector<AssetFile> files;  // by path in the folder of the export
  std::string refused;           // why the form does not express the task; then there are no files
};
/// Expresses a task with its demonstration in M1. Errors: of a start that cannot be written at all.
using ExpressTask = std::function<Result<ExpressedTask>(const FinishedTask&)>;

/// What the formats of these names write of a task. The request must outlive the result, which several threads may
/// call. Errors: those of the tables of the format.
Result<ExpressTask> express_ai2thor(const ExportRequest& request);
Result<ExpressTask> express_virtualhome(const ExportRequest& request);
Result<ExpressTask> express_virtualhome_unity(const ExportRequest& request);
Result<ExpressTask> express_behavior(const ExportRequest& request);

/// Why Habitat's form does not express a task of Habitat; "" when it does.
std::string refused_by_habitat(const FinishedTask& task);

/// Writes each task of a data set that is expressed, and left_out.jsonl. Errors: as write_task_folder.
Result<std::string> write_expressed(const ExportRequest& request, const Result<ExpressTask>& express);

/// Why a task cannot be done in its simulator itself; "" when it can. Of a task in the profile `native`, each object
/// that the demonstration handles is one of the simulator's own scene, or the simulator has a model of it; and the
/// simulator's form, in VirtualHome the one for Unity, expresses the task, so that each state of the goal and each
/// action of the demonstration is one that the simulator has.
using NativeCheck = std::function<Result<std::string>(const FinishedTask&)>;
/// As above. The request must outlive the result, which several threads may call.
Result<NativeCheck> native_check(const ExportRequest& request);

}  // namespace unietp
