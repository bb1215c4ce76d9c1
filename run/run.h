#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dataset/balance.h"
#include "dataset/configuration.h"
#include "dataset/lines.h"
#include "resources/resources.h"
#include "run/shard.h"
#include "run/simulator_check.h"
#include "run/stage_costs.h"

namespace unietp {

/// Counts for a progress line.
struct RunProgress {
  int tasks = 0, asked = 0;  // accepted so far, wanted
  int candidates = 0;        // tried so far
  double seconds = 0;        // since this process began
  int tasks_now = 0;         // accepted by this process, for the rate
};

/// How the run is carried out. Does not affect the data set, but for `in_simulator`, which the program always gives.
struct RunOptions {
  std::filesystem::path out;
  std::filesystem::path licenses;  // table of the sources' licenses, for the manifest
  int threads = 1;
  bool resume = false;
  std::filesystem::path ledger;                      // a copy of the ledger, with what candidates cost; "" for none
  Shard shard;                                       // the part of the run that this process makes
  const std::atomic<bool>* stop = nullptr;           // set from outside: finish the current candidates, then return
  std::function<void(const RunProgress&)> progress;  // called with a lock held; may be empty
  StageCosts* costs = nullptr;                       // the run's costs are added to it; may be null
  SimulatorCheck in_simulator;                       // the forms of each task; empty: they have none, native or not
};

/// A slot that has no task after its last attempt.
struct UnfilledSlot {
  int slot = 0;
  std::string description;             // "logical task on habitat"
  std::optional<RejectionEntry> last;  // why its last candidate was given up
};

/// What a run, or a shard of it, has produced.
struct RunReport {
  bool interrupted = false;  // nothing was written but the ledger
  int tasks = 0, asked = 0;  // of the shard
  int candidates = 0;
  double seconds = 0;
  std::vector<Spread> balance;  // of the tasks taken
  std::vector<UnfilledSlot> unfilled;
};

/// Fills the slots of a configuration, block by block, and writes the data set to `options.out`, all or nothing: work
/// is kept in `<out>.partial` and renamed at the end. A shard writes a folder that `merge_shards` (merge.h) reads
/// instead. Errors: Usage when the folder exists, is in use or belongs to another run, or when there are fewer blocks
/// than shards; Io.
Result<RunReport> run_generation(const RunConfiguration& configuration, const Resources& resources,
                                 const RunOptions& options);

/// The name of a run: program version, knowledge digest and configuration, as one line.
std::string identity_of(const RunConfiguration& configuration, const Resources& resources);

}  // namespace unietp
