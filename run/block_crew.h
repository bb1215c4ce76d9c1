#pragma once

#include <atomic>
#include <functional>
#include <vector>

#include "run/block_run.h"

namespace unietp {

/// How a crew works; no part of it reaches the data set.
struct CrewOrders {
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  // set from outside: finish the pieces under way, then return
  BlockNews news;
  /// Called for each block that is done, in their order, by one thread at a time while the others go on with the next.
  /// An error ends the work.
  std::function<Result<Done>(const Block&, const BlockRun&)> done;
};

/// Fills all blocks. While the last pieces of one are under way and while it is planned, idle threads begin the next:
/// so no thread waits, and only a few blocks' homes are in memory at a time. False when stopped from outside. Errors:
/// Io of the ledger; those of `done`.
Result<bool> fill_blocks(const RunConfiguration& configuration, const Resources& resources,
                         const std::vector<Block>& blocks, Ledger& ledger, const CrewOrders& orders);

}  // namespace unietp
