#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exports/finished_tasks.h"
#include "exports/formats.h"
#include "interchange/habitat_assets.h"
#include "scene/simulator_forms.h"

namespace unietp {

/// What a form of its simulator makes of a task.
struct ExpressedTask {
  std::string refused;  // why the form does not express the task; "" where it does
  /// The files by their paths in the folder of the export; empty where it is refused. Called while the task is there.
  std::function<Result<std::vector<AssetFile>>()> files;
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

/// The one of these that a form of simulators is written with; Habitat's, which is written for all tasks together, only
/// says why it refuses. Errors: as above.
Result<ExpressTask> express_form(SimulatorForm::Kind form, const ExportRequest& request);

/// Writes each task of a data set that is expressed, and left_out.jsonl. Errors: as write_task_folder.
Result<ExportSummary> write_expressed(const ExportRequest& request, const Result<ExpressTask>& express);

/// What the forms of its simulator (scene/simulator_forms.h) say of a task with its demonstration in M1.
struct FormSupport {
  std::vector<std::string> express;  // the forms that express it, in their order
  std::string refused;               // why the strictest one does not; "" where it does
};
using FormCheck = std::function<FormSupport(const FinishedTask&)>;
/// Asks what writes each form, without writing. The request must outlive the result, which several threads may call.
/// Errors: those of the tables of the formats.
Result<FormCheck> form_check(const ExportRequest& request);

/// Why a task cannot be done in its simulator itself; "" when it can. Of a task in the profile `native`, each object
/// that the demonstration handles is one of the simulator's own scene, or the simulator has a model of it; and the
/// simulator's strictest form expresses the task, so that each state of the goal and each action of the demonstration
/// is one that the simulator has (exports/own_scene.h).
std::string refused_in_simulator(const FinishedTask& task, const FormSupport& support, const Knowledge& knowledge);

}  // namespace unietp
