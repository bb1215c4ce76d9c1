#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "pipeline/configuration.h"
#include "pipeline/ledger.h"
#include "pipeline/resources.h"

namespace unietp {

/// Slots of a block, and the ledger that has their candidates.
struct FilledBlock {
  int first = 0, slots = 0;
  Ledger* ledger = nullptr;
};

/// Writes the data set that the ledgers hold to an empty folder. `blocks` are all blocks of the run, in order; of
/// `resources` only the knowledge and its digest are read. Equal ledgers give equal bytes, whoever filled them. Errors:
/// Io.
Result<Done> assemble(const std::filesystem::path& folder, const RunConfiguration& configuration,
                      const Resources& resources, const std::filesystem::path& licences,
                      const std::vector<FilledBlock>& blocks);

}  // namespace unietp
