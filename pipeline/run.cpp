#include "pipeline/run.h"

#include <algorithm>
#include <chrono>

#include <nlohmann/json.hpp>

#include "pipeline/assemble.h"
#include "pipeline/block_run.h"
#include "pipeline/configuration_json.h"
#include "pipeline/manifest.h"
#include "pipeline/run_folder.h"
#include "pipeline/shard_folder.h"

namespace unietp {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// What a run has come to so far: counts for the progress line, then the report.
class Account {
 public:
  Account(const RunOptions& options, int asked) : options_(options) { now_.asked = asked; }

  void candidate(bool accepted) {
    ++now_.candidates;
    if (accepted) ++now_.tasks, ++now_.tasks_now;
    if (!options_.progress) return;
    now_.seconds = seconds_since(start_);
    options_.progress(now_);
  }

  /// A block has ended: what its ledger says replaces what was counted while it was filled.
  void block(const Block& block, const BlockRun& run, int attempts, Ledger& ledger) {
    const auto outlines = run.outlines();
    candidates_ += static_cast<int>(outlines.size());
    tasks_ += run.selection().taken();
    now_.candidates = candidates_;
    now_.tasks = tasks_;
    for (const auto& record : outlines) {
      if (run.selection().chosen(record.slot) == record.attempt) taken_.add(traits_from(record.traits));
    }
    for (const int open : run.selection().open_slots()) {
      const auto& slot = block.slots[static_cast<std::size_t>(open - block.first())];
      unfilled_.push_back(
          {open, std::string(name_of(slot.split)) + " task on " + std::string(name_of(slot.simulator)), ""});
      if (const auto record = ledger.read(open, attempts - 1); record && !record->accepted)
        unfilled_.back().last_reason = record->rejection;
    }
  }

  RunReport report() const {
    return {false, tasks_, now_.asked, candidates_, seconds_since(start_), taken_.spreads(), unfilled_};
  }

 private:
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

/// Aside first, then renamed, in place of what was there.
Result<Done> keep_ledger(Ledger& ledger, const std::filesystem::path& path) {
  const auto aside = path.string() + ".tmp";
  std::error_code code;
  std::filesystem::remove(aside, code);
  if (auto copied = ledger.copy_to(aside, true); !copied) return copied;
  std::filesystem::rename(aside, path, code);
  if (code) return Error{Error::Kind::Io, path.string(), {}, "cannot rename the ledger into place: " + code.message()};
  return Done{};
}

Result<Done> publish(RunFolder& work, const RunConfiguration& configuration, const Resources& resources,
                     const RunOptions& options, const std::vector<Block>& blocks, Ledger& ledger) {
  const StageTimer timer(options.costs, Stage::Dataset);
  const auto folder = work.fresh_data_folder();
  if (!folder) return folder.error();
  std::vector<FilledBlock> filled;
  for (const Block& block : blocks) filled.push_back({block.first(), static_cast<int>(block.slots.size()), &ledger});
  const auto written = options.shard.is_whole()
                           ? assemble(*folder, configuration, resources, options.licences, filled)
                           : write_shard(*folder, options.shard, identity_of(configuration, resources), filled);
  if (!written) return written.error();
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
                 "this run has " + std::to_string(all.size()) + " blocks, so it cannot be shared by " +
                     std::to_string(options.shard.of) + "; ask for fewer shards or set a smaller block"};
  const auto blocks = share_of(std::move(all), options.shard);
  int asked = 0;
  for (const Block& block : blocks) asked += static_cast<int>(block.slots.size());

  auto work = RunFolder::enter(options.out, options.resume);
  if (!work) return work.error();
  if (work->already_published()) return RunReport{false, asked, asked, 0, 0, {}, {}};
  auto ledger = Ledger::open(work->ledger(), identity_of(configuration, resources));
  if (!ledger) return ledger.error();

  Account account(options, asked);
  const BlockWork how{options.threads, options.costs, options.stop,
                      [&account](bool accepted) { account.candidate(accepted); }};
  for (const Block& block : blocks) {
    BlockRun run(configuration, resources, block, *ledger, how);
    const auto filled = run.fill();
    if (!filled) return filled.error();
    account.block(block, run, configuration.attempts, *ledger);
    if (*filled) continue;
    auto report = account.report();
    report.interrupted = true;
    return report;
  }
  auto report = account.report();
  if (auto published = publish(*work, configuration, resources, options, blocks, *ledger); !published)
    return published.error();
  return report;
}

}  // namespace unietp
