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
#include "run/simulator_check.h"
#include "run/stage_costs.h"

namespace unietp {

/// Callbacks of a block while it is filled, called from several threads. Only `in_simulator` affects the data set.
struct BlockCallbacks {
  std::function<void(const StageCosts&)> on_costs;  // time spent since the last call
  std::function<void(bool accepted)> on_candidate;  // a candidate is finished
  SimulatorCheck in_simulator;                      // empty: tasks have no forms
};

/// Fills a block's slots in batches of work: first its homes, then attempt k of all open slots; after each attempt
/// duplicates are rejected in slot order. The pieces of a batch may be done by any threads in any order, so neither the
/// number of threads nor a killed process changes the result.
class BlockRun {
 public:
  /// All must outlive it.
  BlockRun(const RunConfiguration& configuration, const Resources& resources, const Block& block, Ledger& ledger,
           const BlockCallbacks& callbacks);

  /// Ends the previous batch, all of whose pieces are done, and gives the number of pieces of the next one; 0 when all
  /// slots are filled or have used up their attempts. Continues from what the ledger has. One thread at a time. Errors:
  /// Io of the ledger.
  Result<std::size_t> next_batch();
  /// Does one piece of the batch. Several threads at a time.
  void work(std::size_t piece);

  /// The slots filled so far.
  const Selection& selection() const { return selection_; }
  /// Every candidate that the ledger has of the block, in order of attempt, then slot, without texts.
  std::vector<CandidateRecord> outlines() const;
  /// Candidates made by this process, and how many of them were accepted.
  int tried() const { return tried_; }
  int accepted() const { return accepted_; }

 private:
  using Round = std::vector<CandidateRecord>;  // of one attempt

  /// All slots are filled or have used up their attempts.
  bool is_complete() const;
  /// Rejects what repeats another task, in slot order.
  void end_round();
  void draw_home(std::size_t which);
  void try_plan(const CandidatePlan& plan);
  void add_to_ledger(CandidateRecord record, const StageCosts& costs);

  const RunConfiguration& configuration_;
  const Resources& resources_;
  const Block& block_;
  Ledger& ledger_;
  const BlockCallbacks& callbacks_;
  LayoutPool layouts_;
  CandidatePlanner planner_;
  Frequencies taken_;
  Selection selection_;
  std::vector<Round> rounds_;                     // by attempt, each in slot order
  std::vector<std::pair<Simulator, int>> homes_;  // the first batch; plans need all homes
  std::vector<CandidatePlan> plans_;              // the batch, once an attempt has begun
  bool started_ = false;
  int attempt_ = -1;  // current one; -1 while homes are made

  std::mutex mutex_;  // guards the current round and everything below
  int tried_ = 0, accepted_ = 0;
  std::optional<Error> failure_;
};

}  // namespace unietp
