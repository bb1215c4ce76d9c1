#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "run/blocks.h"
#include "run/candidate_planner.h"
#include "run/layout_pool.h"
#include "run/ledger.h"
#include "run/selection.h"
#include "run/stage_costs.h"

namespace unietp {

/// Whom a block tells what it does, from several threads; no part of it reaches the data set.
struct BlockNews {
  std::function<void(const StageCosts&)> spent;
  std::function<void(bool accepted)> tried;  // a candidate, now
};

/// Fills a block's slots in batches of work: first its homes, then attempt k of all open slots; after each attempt
/// duplicates are turned away in slot order. The pieces of a batch may be done by any threads in any order, so neither
/// threads nor a kill change what becomes of the block.
class BlockRun {
 public:
  /// All must outlive it.
  BlockRun(const RunConfiguration& configuration, const Resources& resources, const Block& block, Ledger& ledger,
           const BlockNews& news);

  /// Ends the batch before, all of whose pieces are done, and says how many the next one has; 0 when all slots are
  /// filled or were tried as often as they may be. Goes on from what the ledger has. One thread at a time. Errors: Io
  /// of the ledger.
  Result<std::size_t> next_batch();
  /// Does one piece of the batch. Several threads at a time.
  void work(std::size_t piece);

  const Selection& selection() const { return selection_; }
  /// Every candidate that the ledger has of the block, in order of attempt, then slot, without texts.
  std::vector<CandidateRecord> outlines() const;
  /// Candidates of this process, and how many of them were accepted.
  int tried() const { return tried_; }
  int accepted() const { return accepted_; }

 private:
  using Round = std::vector<CandidateRecord>;  // of one attempt

  /// All slots are filled, or were tried as often as they may be.
  bool is_complete() const;
  /// Turns away what repeats another, in slot order.
  void end_round();
  void draw_home(std::size_t which);
  void try_plan(const CandidatePlan& plan);
  void keep(CandidateRecord record, const StageCosts& costs);

  const RunConfiguration& configuration_;
  const Resources& resources_;
  const Block& block_;
  Ledger& ledger_;
  const BlockNews& news_;
  LayoutPool layouts_;
  CandidatePlanner planner_;
  Frequencies taken_;
  Selection selection_;
  std::vector<Round> rounds_;                     // by attempt, each in slot order
  std::vector<std::pair<Simulator, int>> homes_;  // the first batch; plans need all homes
  std::vector<CandidatePlan> plans_;              // the batch, once an attempt has begun
  bool begun_ = false;
  int attempt_ = -1;  // under way

  std::mutex mutex_;  // guards the round under way and everything below
  int tried_ = 0, accepted_ = 0;
  std::optional<Error> failure_;
};

}  // namespace unietp
