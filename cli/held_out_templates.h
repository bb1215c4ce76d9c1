#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "resources/resources.h"

namespace unietp {

/// The templates that `unietp training --hold-out-templates` leaves out: data/runs/held_out_templates.txt. Errors: Io.
Result<std::vector<std::string>> held_out_templates(const DataFolders& folders);

}  // namespace unietp
