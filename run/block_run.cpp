#include "run/block_run.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/files.h"
#include "generator/rejection.h"
#include "run/make_task.h"
#include "scene/scene_json.h"

namespace unietp {
namespace {

/// Whether other candidates of the template are nearly always rejected for the same: of a hundred that followed in a
/// slot of a training run, one to five were accepted.
bool is_of_template(std::string_view reason) {
  using enum RejectionReason;
  const auto named = rejection_reason_named(reason);
  return named == NoReferringConstraint || named == NoWording || named == Senseless;
}

}  // namespace

BlockRun::BlockRun(const RunConfiguration& configuration, const Resources& resources, const Block& block,
                   Ledger& ledger, const BlockCallbacks& callbacks)
    : configuration_(configuration),
      resources_(resources),
      block_(block),
      ledger_(ledger),
      callbacks_(callbacks),
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

void BlockRun::add_to_ledger(CandidateRecord record, const StageCosts& costs) {
  const auto added = ledger_.add(record, costs);
  const std::scoped_lock lock(mutex_);
  if (!added) {
    failure_ = added.error();
    return;
  }
  ++tried_;
  if (record.accepted) ++accepted_;
  if (callbacks_.on_candidate) callbacks_.on_candidate(record.accepted);
  rounds_[static_cast<std::size_t>(attempt_)].push_back(outline_of(std::move(record)));
}

void BlockRun::draw_home(std::size_t which) {
  StageCosts costs;
  {
    const StageTimer timer(&costs, Stage::Homes);
    const auto& layout = layouts_.layout(homes_[which].first, homes_[which].second);
    if (layout) {
      const Scene& home = layout->home.scene;
      const auto kept = ledger_.keep_home(home.id, [&home] { return gzip(scene_to_json(home)); });
      const std::scoped_lock lock(mutex_);
      if (!kept) failure_ = kept.error();
    }
  }
  callbacks_.on_costs(costs);
}

void BlockRun::try_plan(const CandidatePlan& plan) {
  const auto& slot = block_.slots[static_cast<std::size_t>(plan.slot - block_.first())];
  StageCosts costs;
  auto made = make_task(configuration_, resources_, layouts_, slot, plan, planner_.counts(), &costs);
  StageTimer timer(&costs, Stage::Writing);
  if (auto* task = std::get_if<Task>(&made); task != nullptr && callbacks_.in_simulator) {
    SimulatorSupport support = callbacks_.in_simulator(*task);
    task->forms = std::move(support.forms);
    if (configuration_.native && !support.refused.empty()) {
      const auto& specification = task->episode.specification;
      made = RejectedCandidate{{RejectionReason::GateSimulator, std::move(support.refused)},
                               specification.template_name,
                               specification.simulator,
                               specification.split,
                               task->slot,
                               task->attempt};
    }
  }
  auto record = record_of(made);
  timer.enter(Stage::Ledger);
  add_to_ledger(std::move(record), costs);
  timer.stop();
  callbacks_.on_costs(costs);
}

void BlockRun::work(std::size_t piece) {
  if (attempt_ < 0) return draw_home(piece);
  try_plan(plans_[piece]);
}

void BlockRun::end_round() {
  Round& round = rounds_[static_cast<std::size_t>(attempt_)];
  std::sort(round.begin(), round.end(), [](const auto& a, const auto& b) { return a.slot < b.slot; });
  for (const auto& record : round) {
    if (record.accepted && selection_.offer(record) == Selection::Verdict::Taken)
      taken_.add(traits_from(record.traits));
    if (is_of_template(record.rejection.reason)) planner_.drop_template(record.slot);
  }
}

Result<std::size_t> BlockRun::next_batch() {
  if (failure_) return *failure_;
  if (!started_) {
    started_ = true;
    auto outlines = ledger_.outlines(block_.first(), static_cast<int>(block_.slots.size()));
    if (!outlines) return outlines.error();
    for (auto& outline : *outlines) {
      if (outline.attempt < 0 || outline.attempt >= configuration_.attempts)
        return Error{Error::Kind::Schema,
                     "ledger.sqlite",
                     {},
                     "is damaged: slot " + std::to_string(outline.slot) + " has an attempt " +
                         std::to_string(outline.attempt) + " of " + std::to_string(configuration_.attempts)};
      rounds_[static_cast<std::size_t>(outline.attempt)].push_back(std::move(outline));
    }
    if (is_complete()) {  // by an earlier process, so neither homes nor plans are needed
      selection_.offer_all(this->outlines());
      return std::size_t{0};
    }
    for (const auto simulator : configuration_.simulators) {
      for (int home = 0; home < layouts_.size(simulator); ++home) homes_.emplace_back(simulator, home);
    }
    if (!homes_.empty()) return homes_.size();
  }
  if (attempt_ >= 0) end_round();
  while (++attempt_ < configuration_.attempts) {
    const auto open = selection_.open_slots();
    if (open.empty()) break;
    // Plans are made for all open slots, also those whose candidate an earlier process made, since they count for the
    // balance of the others.
    StageCosts costs;
    {
      const StageTimer timer(&costs, Stage::Planning);
      plans_ = planner_.round(open, attempt_, taken_);
    }
    callbacks_.on_costs(costs);
    const Round& found = rounds_[static_cast<std::size_t>(attempt_)];
    std::erase_if(plans_, [&](const CandidatePlan& plan) {
      return std::any_of(found.begin(), found.end(), [&](const auto& one) { return one.slot == plan.slot; });
    });
    if (!plans_.empty()) return plans_.size();
    end_round();
  }
  return std::size_t{0};
}

}  // namespace unietp
