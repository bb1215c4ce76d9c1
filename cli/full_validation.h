#pragma once

#include "core/result.h"
#include "resources/resources.h"
#include "validator/validation_options.h"

namespace unietp {

/// All that the validator can hold a data set against, from the other rooms: texts, templates, homes, starts, forms and
/// derived files. `resources` must outlive it. Errors: those of read_known_homes and forms_of_tasks.
Result<ValidationOptions> full_validation(const Resources& resources, const DataFolders& folders);

}  // namespace unietp
