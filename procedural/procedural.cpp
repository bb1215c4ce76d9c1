#include "procedural/procedural.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "core/limits.h"
#include "core/rng.h"
#include "dataset/configuration.h"
#include "dataset/task.h"
#include "procedural/simulator_data.h"
#include "run/candidate_planner.h"
#include "run/layout_pool.h"
#include "run/make_task.h"
#include "run/slots.h"

namespace unietp {
namespace {

constexpr int kAttemptsPerHome = 24;  // candidates in one home before another is taken
// The number of the first home in the training pool. A run has no more homes than tasks, so no data set has it.
constexpr int kFirstHome = limits::kTasks;

Error option_error(const std::string& option, std::string message) {
  return {Error::Kind::Usage, option, {}, std::move(message)};
}

/// The settings of a run for one task of a kind.
RunConfiguration run_of_one(const ProceduralOptions& options, Simulator simulator, Split split, std::uint64_t seed) {
  RunConfiguration run;
  run.count = 1;
  run.seed = seed;
  run.simulators = {simulator};
  run.splits = {split};
  run.templates = options.templates;
  run.modes = options.modes;
  run.sense = options.sense;
  run.attempts = options.attempts;
  run.homes = HomeSource::Training;
  return run;
}

TaskText text_of(const Task& task, std::uint64_t seed) {
  const Specification& specification = task.episode.specification;
  TaskText text;
  text.id = std::string(name_of(specification.simulator)) + "-seed-" + std::to_string(seed);
  text.instruction = task.instruction.text;
  text.split = name_of(specification.split);
  text.template_name = specification.template_name;
  text.layout = task.episode.layout;
  text.goal_text = to_text(specification.goal);
  const auto count = [&](const Demonstration& shown) {
    const auto failures = std::count_if(shown.steps.begin(), shown.steps.end(),
                                        [](const DemonstrationStep& step) { return !step.outcome.success; });
    text.expert.push_back(
        {shown.mode, static_cast<int>(shown.steps.size()), static_cast<int>(failures), shortest_steps(shown)});
  };
  count(task.demonstration);
  for (const Demonstration& shown : task.in_other_modes) count(shown);
  return text;
}

}  // namespace

struct Procedural::Impl {
  /// What tasks of one simulator can be.
  struct Kind {
    Simulator simulator = Simulator::Ai2thor;
    std::vector<Split> splits;
    std::vector<std::unique_ptr<LayoutPool>> homes;  // one home each, made when it is first asked for
  };

  Impl(std::shared_ptr<const Resources> all, ProceduralOptions wanted)
      : resources(std::move(all)), data(simulator_data(resources)), options(std::move(wanted)) {
    of_homes.homes = HomeSource::Training;
    of_homes.seed = options.homes_seed;
  }

  Result<Done> add(Simulator simulator);
  std::variant<SharedTask, Error> try_home(const Kind& kind, Split split, LayoutPool& home, std::uint64_t seed,
                                           std::uint64_t stream, int& attempts_left) const;

  std::shared_ptr<const Resources> resources;
  AllSimulatorData data;
  ProceduralOptions options;
  RunConfiguration of_homes;
  std::vector<Kind> kinds;
};

Result<Done> Procedural::Impl::add(Simulator simulator) {
  Kind kind{simulator, {}, {}};
  Error last;
  for (const Split split : options.splits.empty() ? all_splits() : options.splits) {
    const auto slots = plan_slots(run_of_one(options, simulator, split, 0), *resources);
    if (slots) {
      kind.splits.push_back(split);
    } else {
      last = slots.error();
    }
  }
  if (kind.splits.empty()) return last;
  for (int number = 0; number < options.homes; ++number) {
    BlockHomes one{};
    one[static_cast<std::size_t>(simulator)] = {kFirstHome + number, 1};
    kind.homes.push_back(std::make_unique<LayoutPool>(of_homes, *resources, one));
  }
  kinds.push_back(std::move(kind));
  return Done{};
}

Result<Procedural> Procedural::make(std::shared_ptr<const Resources> resources, const ProceduralOptions& options) {
  if (options.homes < 1 || options.homes > limits::kProceduralHomes)
    return option_error("homes", "expected 1 to " + std::to_string(limits::kProceduralHomes));
  if (options.attempts < 1 || options.attempts > limits::kAttempts)
    return option_error("attempts", "expected 1 to " + std::to_string(limits::kAttempts));
  if (options.simulators.empty()) return option_error("simulators", "expected at least one");
  Procedural made;
  made.impl_ = std::make_shared<Impl>(std::move(resources), options);
  std::vector<Mode>& modes = made.impl_->options.modes;
  if (std::find(modes.begin(), modes.end(), Mode::M1) == modes.end()) modes.push_back(Mode::M1);
  std::sort(modes.begin(), modes.end());
  modes.erase(std::unique(modes.begin(), modes.end()), modes.end());
  for (const Simulator simulator : options.simulators) {
    if (auto added = made.impl_->add(simulator); !added) return added.error();
  }
  return made;
}

/// Candidates in one home until one is accepted, or an error with the reason why the last was not.
std::variant<SharedTask, Error> Procedural::Impl::try_home(const Kind& kind, Split split, LayoutPool& home,
                                                           std::uint64_t seed, std::uint64_t stream,
                                                           int& attempts_left) const {
  Error last{Error::Kind::Unsatisfiable, "seed " + std::to_string(seed), {}, "no candidate was tried"};
  const auto& layout = home.layout(kind.simulator, 0);
  if (!layout) return layout.error();
  const RunConfiguration run = run_of_one(options, kind.simulator, split, stream);
  const auto slots = plan_slots(run, *resources);
  if (!slots) return slots.error();
  CandidatePlanner planner(run, *resources, home, *slots);
  for (int attempt = 0; attempt < kAttemptsPerHome && attempts_left > 0; ++attempt, --attempts_left) {
    const auto plans = planner.round({0}, attempt, {});
    auto made = make_task(run, *resources, home, slots->front(), plans.front(), planner.counts(), nullptr);
    if (const auto* why = std::get_if<RejectedCandidate>(&made)) {
      last.message = std::string(name_of(why->rejection.reason)) + ": " + why->rejection.detail;
      continue;
    }
    Task& task = std::get<Task>(made);
    TaskText text = text_of(task, seed);
    task.episode.start.id = text.id;
    auto ready = prepare_task(std::move(text), std::move(task.episode.start),
                              data[static_cast<std::size_t>(kind.simulator)], layout->home);
    if (!ready) return ready.error();
    return std::move(*ready);
  }
  return last;
}

Result<SharedTask> Procedural::task(std::uint64_t seed) const {
  if (seed > limits::kSeed) return option_error("seed", "expected at most " + std::to_string(limits::kSeed));
  Rng rng = Rng(seed).fork("procedural", 0);
  const Impl::Kind& kind = rng.pick(impl_->kinds);
  const Split split = rng.pick(kind.splits);
  Error last;
  for (int attempts_left = impl_->options.attempts; attempts_left > 0;) {
    LayoutPool& home = *rng.pick(kind.homes);
    const std::uint64_t stream = rng.below(limits::kSeed);
    const int before = attempts_left;
    auto tried = impl_->try_home(kind, split, home, seed, stream, attempts_left);
    if (auto* made = std::get_if<SharedTask>(&tried)) return std::move(*made);
    last = std::get<Error>(std::move(tried));
    if (attempts_left == before) --attempts_left;  // a home that cannot be made
  }
  return last;
}

const ProceduralOptions& Procedural::options() const { return impl_->options; }

}  // namespace unietp
