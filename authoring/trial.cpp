#include "authoring/trial.h"

#include <algorithm>
#include <utility>

#include "generator/weighted_binding.h"
#include "run/sense_of_binding.h"

namespace unietp {
namespace {

void count(std::vector<TemplateTrial::Reason>& reasons, Rejection&& why) {
  const auto same = [&](const TemplateTrial::Reason& one) { return one.reason == why.reason; };
  auto found = std::find_if(reasons.begin(), reasons.end(), same);
  if (found == reasons.end()) found = reasons.insert(found, {.reason = why.reason, .example = why.detail});
  ++found->count;
  found->details.push_back(std::move(why.detail));
  if (why.failure != Failure::None) ++found->failures[why.failure];
}

}  // namespace

TemplateTrial try_template(const RunConfiguration& configuration, const Resources& resources, LayoutPool& layouts,
                           std::size_t position, Simulator simulator, const TrialOptions& options) {
  const auto& source = resources.templates[position];
  auto own = configuration;
  own.seed = Rng(configuration.seed).fork(source.name, static_cast<std::uint64_t>(simulator)).next();
  TaskSlot slot;
  slot.simulator = simulator;
  slot.split = split_of_tasks(source);
  slot.templates = {position};

  const BindingWishes wishes{configuration.binding, [](const Parameter&, const std::string&) { return 1.0; },
                             at_least(configuration.sense, source, resources, simulator)};
  const auto plan_of = [&](int attempt) {
    CandidatePlan plan{0, attempt, position, attempt % layouts.size(simulator), std::nullopt, configuration.sense};
    if (const auto& layout = layouts.layout(simulator, plan.home)) {
      plan.binding = sample_binding(source, resources.backend(simulator).knowledge, layout->offer.categories, wishes,
                                    Rng(own.seed).fork("binding", static_cast<std::uint64_t>(attempt)));
    }
    return plan;
  };
  TemplateTrial trial;
  for (int attempt = 0; attempt < options.tries; ++attempt) {
    if (options.stop != nullptr && options.stop->load()) break;
    auto candidate = make_task(own, resources, layouts, slot, plan_of(attempt), {}, nullptr);
    ++trial.candidates;
    if (auto* rejected = std::get_if<RejectedCandidate>(&candidate)) {
      count(trial.reasons, std::move(rejected->rejection));
    } else {
      trial.tasks.push_back(std::move(std::get<Task>(candidate)));
      if (static_cast<int>(trial.tasks.size()) == options.enough) break;
    }
  }
  std::sort(
      trial.reasons.begin(), trial.reasons.end(), [](const TemplateTrial::Reason& a, const TemplateTrial::Reason& b) {
        const auto names = [](RejectionReason reason) { return std::pair(name_of(stage_of(reason)), name_of(reason)); };
        return a.count != b.count ? a.count > b.count : names(a.reason) < names(b.reason);
      });
  return trial;
}

}  // namespace unietp
