#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"
#include "dataset/configuration.h"
#include "dataset/dataset_writer.h"
#include "resources/resources.h"
#include "run/ledger.h"

namespace unietp {

/// Slots of a finished block, and the ledger that has their candidates.
struct FilledBlock {
  int first = 0, slots = 0;
  Ledger* ledger = nullptr;
};

/// Adds the tasks of one block and the rejections of its other candidates. Blocks must come in the order of the run.
/// Errors: Io.
Result<Done> add_block(DatasetWriter& writer, const FilledBlock& block, int attempts);

/// Writes the data set that the ledgers hold to an empty folder. `blocks` are all blocks of the run, in order; of
/// `resources` only the knowledge and its digest are read. Equal ledgers give equal bytes. Errors:
/// Io.
Result<Done> assemble(const std::filesystem::path& folder, const RunConfiguration& configuration,
                      const Resources& resources, const std::filesystem::path& licenses,
                      const std::vector<FilledBlock>& blocks);

}  // namespace unietp
