#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "validator/validate.h"

namespace unietp {

struct PddlExport {
  std::size_t problems = 0, left_out = 0;
};

/// Writes a data set's tasks as PDDL: `<simulator>/domain.pddl`, `<simulator>/<task>.pddl`, the demonstration as a plan
/// of it, `<simulator>/<task>.plan`, and `left-out.csv` (task, reason) with what PDDL does not say. The folder `out`
/// must not exist; it appears as a whole at the end. Errors: those of reading the data set, Io, Usage for a folder that
/// is there.
Result<PddlExport> export_pddl(const std::filesystem::path& dataset, const std::vector<ValidationBackend>& backends,
                               const std::filesystem::path& out);

}  // namespace unietp
