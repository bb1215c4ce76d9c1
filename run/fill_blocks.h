#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "run/block_run.h"

namespace unietp {

/// How blocks are filled. Does not affect the data set.
struct FillOptions {
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  // set from outside: finish the current pieces, then return
  BlockCallbacks callbacks;
  /// Called for each finished block, in the order of the blocks, by one thread at a time while the others fill the
  /// following ones. An error ends the run.
  std::function<Result<Done>(const Block&, const BlockRun&)> on_block;
};

/// Fills all blocks. While the last pieces of a block are being done or it is being planned, idle threads start the
/// next one, so that no thread waits and the homes of only a few blocks are in memory. False when stopped from outside.
/// Errors: Io of the ledger; those of `on_block`.
Result<bool> fill_blocks(const RunConfiguration& configuration, const Resources& resources,
                         const std::vector<Block>& blocks, Ledger& ledger, const FillOptions& options);

}  // namespace unietp
