#include "pipeline/run.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include <nlohmann/json.hpp>

#include "pipeline/candidate_planner.h"
#include "pipeline/dataset_writer.h"
#include "pipeline/ledger.h"
#include "pipeline/manifest.h"
#include "pipeline/run_folder.h"
#include "pipeline/selection.h"

namespace unietp {
namespace {

using Clock = std::chrono::steady_clock;
using Outlines = std::vector<std::vector<CandidateRecord>>;  // by attempt, in slot order

/// One run under way: the slots, what has been found, and the threads that look for more.
class Run {
 public:
  Run(const RunConfiguration& configuration, const Resources& resources, const RunOptions& options, Ledger& ledger,
      std::vector<TaskSlot> slots)
      : configuration_(configuration),
        resources_(resources),
        options_(options),
        ledger_(ledger),
        slots_(std::move(slots)),
        layouts_(configuration, resources),
        planner_(configuration, resources, layouts_, slots_),
        selection_(slots_.size()),
        duplicates_(slots_.size()) {}

  /// Errors: Io of the ledger. False when stopped from outside.
  Result<bool> fill_slots();
  Result<Done> write(const std::filesystem::path& folder);
  RunReport report() const;

 private:
  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }
  /// Calls `work(i)` for each i below `count`, several at a time, until stopped.
  void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);
  /// Plans need all homes; drawing them one by one would leave threads idle.
  void draw_homes();
  /// Makes the planned candidates, several at a time, and adds what comes of it to `found`.
  Result<Done> try_plans(const std::vector<CandidatePlan>& plans, std::vector<CandidateRecord>& found);
  void keep(CandidateRecord record, std::vector<CandidateRecord>& found);
  void book(const StageCosts& costs);
  std::string duplicate_line(const CandidateRecord& record, Selection::Verdict verdict) const;
  void tell();

  const RunConfiguration& configuration_;
  const Resources& resources_;
  const RunOptions& options_;
  Ledger& ledger_;
  std::vector<TaskSlot> slots_;
  LayoutPool layouts_;
  CandidatePlanner planner_;
  Frequencies taken_;
  Selection selection_;
  std::vector<std::vector<std::pair<int, std::string>>> duplicates_;  // by slot: attempt, line of rejections.jsonl

  std::mutex mutex_;  // guards the ledger and everything below
  std::optional<Error> failure_;
  std::exception_ptr thrown_;
  int candidates_ = 0, accepted_now_ = 0, accepted_in_round_ = 0;
  Clock::time_point start_ = Clock::now();
};

void Run::tell() {
  if (!options_.progress) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  options_.progress(
      {selection_.taken() + accepted_in_round_, static_cast<int>(slots_.size()), candidates_, seconds, accepted_now_});
}

void Run::keep(CandidateRecord record, std::vector<CandidateRecord>& found) {
  const std::scoped_lock lock(mutex_);
  if (failure_) return;
  if (const auto added = ledger_.add(record); !added) {
    failure_ = added.error();
    return;
  }
  ++candidates_;
  if (record.accepted) ++accepted_now_, ++accepted_in_round_;
  for (auto* text : {&record.task, &record.demonstration, &record.scene, &record.rejection}) text->clear();
  found.push_back(std::move(record));
  tell();
}

void Run::book(const StageCosts& costs) {
  const std::scoped_lock lock(mutex_);
  if (options_.costs != nullptr) options_.costs->add(costs);
}

void Run::in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t i = next++; i < count && !stopped(); i = next++) {
      try {
        work(i);
      } catch (...) {  // a broken invariant: carried to the caller's thread
        const std::scoped_lock lock(mutex_);
        thrown_ = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < options_.threads; ++i) threads.emplace_back(take);
  take();
  for (auto& thread : threads) thread.join();
  if (thrown_) std::rethrow_exception(thrown_);
}

void Run::draw_homes() {
  std::vector<std::pair<Simulator, int>> homes;
  for (const auto simulator : configuration_.simulators) {
    for (int home = 0; home < layouts_.size(simulator); ++home) homes.emplace_back(simulator, home);
  }
  in_parallel(homes.size(), [&](std::size_t i) {
    StageCosts costs;
    {
      const StageTimer timer(&costs, Stage::Homes);
      (void)layouts_.layout(homes[i].first, homes[i].second);
    }
    book(costs);
  });
}

Result<Done> Run::try_plans(const std::vector<CandidatePlan>& plans, std::vector<CandidateRecord>& found) {
  in_parallel(plans.size(), [&](std::size_t i) {
    const auto& slot = slots_[static_cast<std::size_t>(plans[i].slot)];
    StageCosts costs;
    const auto made = make_task(configuration_, resources_, layouts_, slot, plans[i], planner_.counts(), &costs);
    StageTimer timer(&costs, Stage::Writing);
    auto record = record_of(made);
    timer.enter(Stage::Ledger);
    keep(std::move(record), found);
    timer.stop();
    book(costs);
  });
  if (failure_) return *failure_;
  return Done{};
}

Result<bool> Run::fill_slots() {
  auto outlines = ledger_.outlines();
  if (!outlines) return outlines.error();
  Outlines by_attempt(static_cast<std::size_t>(configuration_.attempts));
  for (auto& outline : *outlines) {
    ++candidates_;
    by_attempt[static_cast<std::size_t>(outline.attempt)].push_back(std::move(outline));
  }
  draw_homes();
  for (int attempt = 0; attempt < configuration_.attempts; ++attempt) {
    const auto open = selection_.open_slots();
    if (open.empty() || stopped()) break;
    auto& found = by_attempt[static_cast<std::size_t>(attempt)];
    // Plans are made for all open slots, also those whose candidate an earlier process made: they count for the others.
    StageTimer timer(options_.costs, Stage::Planning);
    auto plans = planner_.round(open, attempt, taken_);
    timer.stop();
    std::erase_if(plans, [&](const CandidatePlan& plan) {
      return std::any_of(found.begin(), found.end(), [&](const auto& one) { return one.slot == plan.slot; });
    });
    accepted_in_round_ = static_cast<int>(
        std::count_if(found.begin(), found.end(), [](const CandidateRecord& record) { return record.accepted; }));
    if (auto tried = try_plans(plans, found); !tried) return tried.error();
    if (stopped()) return false;
    std::sort(found.begin(), found.end(),
              [](const CandidateRecord& a, const CandidateRecord& b) { return a.slot < b.slot; });
    for (const auto& record : found) {
      if (!record.accepted) continue;
      const auto verdict = selection_.offer(record);
      if (verdict == Selection::Verdict::Taken)
        taken_.add(traits_from(record.traits));
      else
        duplicates_[static_cast<std::size_t>(record.slot)].emplace_back(attempt, duplicate_line(record, verdict));
    }
    accepted_in_round_ = 0;
  }
  return !stopped();
}

std::string Run::duplicate_line(const CandidateRecord& record, Selection::Verdict verdict) const {
  const auto& slot = slots_[static_cast<std::size_t>(record.slot)];
  const bool same_start = verdict == Selection::Verdict::SameStart;
  return rejection_line({{"pipeline", same_start ? "duplicate-start" : "duplicate-text",
                          same_start ? "an earlier task has this template, binding and start"
                                     : "an earlier task in this home has this instruction"},
                         record.template_name,
                         slot.simulator,
                         slot.split,
                         record.slot,
                         record.attempt});
}

Result<Done> Run::write(const std::filesystem::path& folder) {
  const StageTimer timer(options_.costs, Stage::Dataset);
  auto writer = DatasetWriter::begin(folder);
  if (!writer) return writer.error();
  for (const auto& slot : slots_) {
    const int chosen = selection_.chosen(slot.index);
    const int last = chosen < 0 ? configuration_.attempts - 1 : chosen;
    const auto& repeated = duplicates_[static_cast<std::size_t>(slot.index)];
    for (int attempt = 0; attempt <= last; ++attempt) {
      const auto duplicate =
          std::find_if(repeated.begin(), repeated.end(), [&](const auto& one) { return one.first == attempt; });
      if (duplicate != repeated.end()) {
        if (auto added = writer->add_rejection(duplicate->second); !added) return added.error();
        continue;
      }
      const auto record = ledger_.read(slot.index, attempt);
      if (!record) return record.error();
      const auto added = record->accepted ? writer->add_task(*record) : writer->add_rejection(record->rejection);
      if (!added) return added.error();
    }
  }
  return writer->finish(configuration_, resources_, options_.licences);
}

RunReport Run::report() const {
  RunReport report;
  report.tasks = selection_.taken();
  report.candidates = candidates_;
  report.balance = taken_.spreads();
  report.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  for (const int open : selection_.open_slots()) {
    const auto& slot = slots_[static_cast<std::size_t>(open)];
    UnfilledSlot unfilled{open, std::string(name_of(slot.split)) + " task on " + std::string(name_of(slot.simulator)),
                          ""};
    if (const auto record = ledger_.read(open, configuration_.attempts - 1); record && !record->accepted)
      unfilled.last_reason = record->rejection;
    report.unfilled.push_back(std::move(unfilled));
  }
  return report;
}

}  // namespace

std::string identity_of(const RunConfiguration& configuration, const Resources& resources) {
  return nlohmann::ordered_json{{"version", program_version()},
                                {"knowledge", resources.digest},
                                {"seed", configuration.seed},
                                {"configuration", to_json(configuration)}}
      .dump();
}

Result<RunReport> run_generation(const RunConfiguration& configuration, const Resources& resources,
                                 const RunOptions& options) {
  auto slots = plan_slots(configuration, resources);
  if (!slots) return slots.error();
  auto work = RunFolder::enter(options.out, options.resume);
  if (!work) return work.error();
  if (work->already_published()) return RunReport{false, configuration.count, 0, 0, {}, {}};
  auto ledger = Ledger::open(work->ledger(), identity_of(configuration, resources));
  if (!ledger) return ledger.error();

  Run run(configuration, resources, options, *ledger, std::move(*slots));
  const auto filled = run.fill_slots();
  if (!filled) return filled.error();
  auto report = run.report();
  report.interrupted = !*filled;
  if (report.interrupted) return report;
  const auto folder = work->fresh_data_folder();
  if (!folder) return folder.error();
  if (auto written = run.write(*folder); !written) return written.error();
  if (auto published = work->publish(); !published) return published.error();
  return report;
}

}  // namespace unietp
