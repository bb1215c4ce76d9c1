#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "pipeline/blocks.h"
#include "pipeline/candidate_planner.h"
#include "pipeline/layout_pool.h"
#include "pipeline/ledger.h"
#include "pipeline/selection.h"
#include "pipeline/stage_costs.h"

namespace unietp {

/// How a block is worked on; no part of it reaches the data set.
struct BlockWork {
  int threads = 1;
  StageCosts* costs = nullptr;                  // what the work spends is added to it
  const std::atomic<bool>* stop = nullptr;      // set from outside: finish the candidates under way, then return
  std::function<void(bool accepted)> finished;  // a candidate, now; called with a lock held; may be empty
};

/// Fills a block's slots. Attempt k of all open slots runs in parallel; then, in slot order, duplicates are turned
/// away: so neither threads nor a kill change what becomes of it.
class BlockRun {
 public:
  BlockRun(const RunConfiguration& configuration, const Resources& resources, const Block& block, Ledger& ledger,
           const BlockWork& work);

  /// Goes on from what the ledger has. False when stopped from outside. Errors: Io of the ledger.
  Result<bool> fill();

  const Selection& selection() const { return selection_; }
  /// Every candidate that the ledger has of the block, in order of attempt, then slot, without texts.
  std::vector<CandidateRecord> outlines() const;

 private:
  using Round = std::vector<CandidateRecord>;  // of one attempt

  bool stopped() const { return work_.stop != nullptr && work_.stop->load(); }
  /// All slots are filled, or were tried as often as they may be.
  bool is_complete() const;
  /// Calls `task(i)` for each i below `count`, several at a time, until stopped.
  void in_parallel(std::size_t count, const std::function<void(std::size_t)>& task);
  /// Plans need all homes; drawing them one by one would leave threads idle.
  void draw_homes();
  /// Makes the planned candidates, several at a time, and adds what comes of it to `found`.
  Result<Done> try_plans(const std::vector<CandidatePlan>& plans, Round& found);
  void keep(CandidateRecord record, const StageCosts& costs, Round& found);
  void book(const StageCosts& costs);

  const RunConfiguration& configuration_;
  const Resources& resources_;
  const Block& block_;
  Ledger& ledger_;
  const BlockWork& work_;
  LayoutPool layouts_;
  CandidatePlanner planner_;
  Frequencies taken_;
  Selection selection_;
  std::vector<Round> rounds_;  // by attempt, each in slot order

  std::mutex mutex_;  // guards the ledger and everything below
  std::optional<Error> failure_;
  std::exception_ptr thrown_;
};

}  // namespace unietp
