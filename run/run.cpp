#include "run/run.h"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/file_writer.h"
#include "core/version.h"
#include "dataset/configuration_json.h"
#include "run/assemble.h"
#include "run/fill_blocks.h"
#include "run/run_folder.h"
#include "run/shard_folder.h"

namespace unietp {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Counts of a run for the progress line and the report. Safe to use from several threads.
class RunTotals {
 public:
  RunTotals(const RunOptions& options, int asked) : options_(options) { now_.asked = asked; }

  void add_costs(const StageCosts& costs) {
    const std::scoped_lock lock(mutex_);
    if (options_.costs != nullptr) options_.costs->add(costs);
  }

  void add_candidate(bool accepted) {
    const std::scoped_lock lock(mutex_);
    ++now_.candidates;
    if (accepted) ++now_.tasks, ++now_.tasks_now;
    if (!options_.progress) return;
    now_.seconds = seconds_since(start_);
    options_.progress(now_);
  }

  /// A finished block: what its ledger says replaces what was counted while it was filled.
  void add_block(const Block& block, const BlockRun& run, int attempts, Ledger& ledger) {
    const auto outlines = run.outlines();
    const int candidates = static_cast<int>(outlines.size()), tasks = run.selection().taken();
    const std::scoped_lock lock(mutex_);
    candidates_ += candidates;
    tasks_ += tasks;
    now_.candidates += candidates - run.tried();
    now_.tasks += tasks - run.accepted();
    for (const auto& record : outlines) {
      if (run.selection().chosen(record.slot) == record.attempt) taken_.add(traits_from(record.traits));
    }
    for (const int open : run.selection().open_slots()) {
      const auto& slot = block.slots[static_cast<std::size_t>(open - block.first())];
      unfilled_.push_back(
          {open, std::string(name_of(slot.split)) + " task on " + std::string(name_of(slot.simulator)), {}});
      if (const auto record = ledger.read(open, attempts - 1); record && !record->accepted)
        unfilled_.back().last = record->rejection;
    }
  }

  RunReport report() const {
    return {false, tasks_, now_.asked, candidates_, seconds_since(start_), taken_.spreads(), unfilled_};
  }

 private:
  std::mutex mutex_;
  const RunOptions& options_;
  RunProgress now_;
  int tasks_ = 0, candidates_ = 0;
  Frequencies taken_;
  std::vector<UnfilledSlot> unfilled_;
  Clock::time_point start_ = Clock::now();
};

/// The blocks of the shard, in order.
std::vector<Block> share_of(std::vector<Block> blocks, const Shard& shard) {
  std::vector<Block> own;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (static_cast<int>(b) % shard.of == shard.number - 1) own.push_back(std::move(blocks[b]));
  }
  return own;
}

/// Writes a copy under a temporary name and renames it over `path`, where only another ledger may be by now.
Result<Done> keep_ledger(Ledger& ledger, const std::filesystem::path& path) {
  if (auto free = Ledger::check_replaceable(path); !free) return free;
  const auto temporary = path.string() + ".tmp";
  std::error_code code;
  std::filesystem::remove(temporary, code);
  auto copied = ledger.copy_to(temporary, true);
  if (copied) std::filesystem::rename(temporary, path, code);
  if (copied && !code) return copied;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  if (!copied) return copied;
  return Error{Error::Kind::Io, path.string(), {}, "cannot rename the ledger into place: " + code.message()};
}

/// What a run's folder is of: two shards of one run do not go on in each other's.
std::string identity_in_folder(const RunConfiguration& configuration, const Resources& resources, const Shard& shard) {
  auto identity = nlohmann::ordered_json::parse(identity_of(configuration, resources));
  if (!shard.is_whole()) identity["shard"] = std::to_string(shard.number) + "/" + std::to_string(shard.of);
  return identity.dump();
}

/// After all blocks: finishes the data set of `writer`, or writes the shard, and renames the folder into place.
Result<Done> publish(RunFolder& work, const RunConfiguration& configuration, const Resources& resources,
                     const RunOptions& options, const std::vector<Block>& blocks, Ledger& ledger,
                     std::optional<DatasetWriter>& writer) {
  const StageTimer timer(options.costs, Stage::Dataset);
  if (writer) {
    if (auto written = writer->finish(configuration, resources, options.licenses); !written) return written.error();
  } else {
    const auto folder = work.fresh_data_folder();
    if (!folder) return folder.error();
    std::vector<FilledBlock> filled;
    for (const Block& block : blocks) filled.push_back({block.first(), static_cast<int>(block.slots.size()), &ledger});
    const auto written = write_shard(*folder, options.shard, identity_of(configuration, resources), filled);
    if (!written) return written.error();
  }
  if (!options.ledger.empty()) {
    if (auto kept = keep_ledger(ledger, options.ledger); !kept) return kept;
  }
  return work.publish();
}

}  // namespace

std::string identity_of(const RunConfiguration& configuration, const Resources& resources) {
  return nlohmann::ordered_json{
      {"version", program_version()}, {"knowledge", resources.digest}, {"configuration", to_json(configuration)}}
      .dump();
}

Result<RunReport> run_generation(const RunConfiguration& configuration, const Resources& resources,
                                 const RunOptions& options) {
  const auto slots = plan_slots(configuration, resources);
  if (!slots) return slots.error();
  auto all = blocks_of(configuration, resources, *slots);
  if (options.shard.of > static_cast<int>(all.size()))
    return Error{Error::Kind::Usage,
                 "--shard",
                 {},
                 "this run has " + std::to_string(all.size()) + " blocks, so it cannot be split into " +
                     std::to_string(options.shard.of) + " shards; use fewer shards or a smaller block"};
  const auto blocks = share_of(std::move(all), options.shard);
  int asked = 0;
  for (const Block& block : blocks) asked += static_cast<int>(block.slots.size());

  if (!options.ledger.empty()) {  // now rather than when all is made
    if (auto free = Ledger::check_replaceable(options.ledger); !free) return free.error();
    if (auto writable = check_writable(options.ledger); !writable) return writable.error();
  }
  auto work =
      RunFolder::enter(options.out, identity_in_folder(configuration, resources, options.shard), options.resume);
  if (!work) return work.error();
  if (work->already_published()) return RunReport{false, asked, asked, 0, 0, {}, {}};
  auto ledger = Ledger::open(work->ledger(), identity_of(configuration, resources));
  if (!ledger) return ledger.error();

  std::optional<DatasetWriter> writer;  // of a whole run, block by block; a shard is written at the end
  if (options.shard.is_whole()) {
    const auto folder = work->fresh_data_folder();
    if (!folder) return folder.error();
    auto begun = DatasetWriter::begin(*folder);
    if (!begun) return begun.error();
    writer.emplace(std::move(*begun));
  }
  RunTotals totals(options, asked);
  FillOptions fill{options.threads, options.stop, {}, {}};
  fill.callbacks = {[&](const StageCosts& costs) { totals.add_costs(costs); },
                    [&](bool accepted) { totals.add_candidate(accepted); }, options.in_simulator};
  fill.on_block = [&](const Block& block, const BlockRun& run) -> Result<Done> {
    StageCosts costs;
    StageTimer timer(&costs, Stage::Dataset);
    totals.add_block(block, run, configuration.attempts, *ledger);
    const FilledBlock filled{block.first(), static_cast<int>(block.slots.size()), &*ledger};
    auto added = writer ? add_block(*writer, filled, configuration.attempts) : Result<Done>(Done{});
    timer.stop();
    totals.add_costs(costs);
    return added;
  };
  const auto filled = fill_blocks(configuration, resources, blocks, *ledger, fill);
  if (!filled) return filled.error();
  auto report = totals.report();
  if (!*filled) {
    report.interrupted = true;
    return report;
  }
  if (auto published = publish(*work, configuration, resources, options, blocks, *ledger, writer); !published)
    return published.error();
  return report;
}

}  // namespace unietp
