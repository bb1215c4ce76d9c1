#include "pipeline/block_run.h"

#include <algorithm>
#include <thread>

#include "pipeline/make_task.h"

namespace unietp {

BlockRun::BlockRun(const RunConfiguration& configuration, const Resources& resources, const Block& block,
                   Ledger& ledger, const BlockWork& work)
    : configuration_(configuration),
      resources_(resources),
      block_(block),
      ledger_(ledger),
      work_(work),
      layouts_(configuration, resources, block.homes),
      planner_(configuration, resources, layouts_, block.slots),
      selection_(block.first(), block.slots.size()),
      rounds_(static_cast<std::size_t>(configuration.attempts)) {}

std::vector<CandidateRecord> BlockRun::outlines() const {
  std::vector<CandidateRecord> all;
  for (const Round& round : rounds_) all.insert(all.end(), round.begin(), round.end());
  return all;
}

bool BlockRun::is_complete() const {
  Selection selection(block_.first(), block_.slots.size());
  selection.offer_all(outlines());
  const Round& last = rounds_.back();
  const auto was_tried_last = [&](int slot) {
    return std::any_of(last.begin(), last.end(), [&](const auto& record) { return record.slot == slot; });
  };
  const auto open = selection.open_slots();
  return std::all_of(open.begin(), open.end(), was_tried_last);
}

void BlockRun::keep(CandidateRecord record, const StageCosts& costs, Round& found) {
  const std::scoped_lock lock(mutex_);
  if (failure_) return;
  if (const auto added = ledger_.add(record, costs); !added) {
    failure_ = added.error();
    return;
  }
  if (work_.finished) work_.finished(record.accepted);
  found.push_back(outline_of(std::move(record)));
}

void BlockRun::book(const StageCosts& costs) {
  const std::scoped_lock lock(mutex_);
  if (work_.costs != nullptr) work_.costs->add(costs);
}

void BlockRun::in_parallel(std::size_t count, const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t i = next++; i < count && !stopped(); i = next++) {
      try {
        task(i);
      } catch (...) {  // a broken invariant: carried to the caller's thread
        const std::scoped_lock lock(mutex_);
        thrown_ = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < work_.threads; ++i) threads.emplace_back(take);
  take();
  for (auto& thread : threads) thread.join();
  if (thrown_) std::rethrow_exception(thrown_);
}

void BlockRun::draw_homes() {
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

Result<Done> BlockRun::try_plans(const std::vector<CandidatePlan>& plans, Round& found) {
  in_parallel(plans.size(), [&](std::size_t i) {
    const auto& slot = block_.slots[static_cast<std::size_t>(plans[i].slot - block_.first())];
    StageCosts costs;
    const auto made = make_task(configuration_, resources_, layouts_, slot, plans[i], planner_.counts(), &costs);
    StageTimer timer(&costs, Stage::Writing);
    auto record = record_of(made);
    timer.enter(Stage::Ledger);
    keep(std::move(record), costs, found);
    timer.stop();
    book(costs);
  });
  if (failure_) return *failure_;
  return Done{};
}

Result<bool> BlockRun::fill() {
  auto outlines = ledger_.outlines(block_.first(), static_cast<int>(block_.slots.size()));
  if (!outlines) return outlines.error();
  for (auto& outline : *outlines) rounds_[static_cast<std::size_t>(outline.attempt)].push_back(std::move(outline));
  if (is_complete()) {  // by an earlier process: neither homes nor plans are needed again
    selection_.offer_all(this->outlines());
    return true;
  }
  draw_homes();
  for (int attempt = 0; attempt < configuration_.attempts && !stopped(); ++attempt) {
    const auto open = selection_.open_slots();
    if (open.empty()) break;
    Round& found = rounds_[static_cast<std::size_t>(attempt)];
    // Plans are made for all open slots, also those whose candidate an earlier process made: they count for the others.
    StageTimer timer(work_.costs, Stage::Planning);
    auto plans = planner_.round(open, attempt, taken_);
    timer.stop();
    std::erase_if(plans, [&](const CandidatePlan& plan) {
      return std::any_of(found.begin(), found.end(), [&](const auto& one) { return one.slot == plan.slot; });
    });
    if (auto tried = try_plans(plans, found); !tried) return tried.error();
    if (stopped()) return false;
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
    for (const auto& record : found) {
      if (record.accepted && selection_.offer(record) == Selection::Verdict::Taken)
        taken_.add(traits_from(record.traits));
    }
  }
  return !stopped();
}

}  // namespace unietp
