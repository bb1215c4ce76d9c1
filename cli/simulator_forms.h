#pragma once

#include "cli/commands.h"
#include "core/result.h"
#include "resources/resources.h"
#include "run/simulator_check.h"
#include "validator/validation_options.h"

namespace unietp {

/// What a run asks of each task. `resources` must outlive it. Errors: those of form_check.
Result<SimulatorCheck> simulator_check(const Resources& resources, const DataFolders& folders);

/// What the validator asks of each task. `resources` must outlive it. Errors: those of form_check.
Result<FormsOf> forms_of_tasks(const Resources& resources, const DataFolders& folders);

}  // namespace unietp
