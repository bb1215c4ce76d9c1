// The whole path of a task on one core, and what share of it each stage takes: the baseline that later work is
// compared with (docs/evidence.md).
#include <chrono>
#include <filesystem>
#include <variant>

#include <benchmark/benchmark.h>

#include "pipeline/candidate.h"
#include "pipeline/make_task.h"
#include "pipeline/slots.h"

namespace {

using namespace unietp;

const ResourcesReading& committed() {
  static const ResourcesReading kReading =
      load_resources({UNIETP_SOURCE_DIR, std::filesystem::temp_directory_path() / "unietp-bench-cache"});
  return kReading;
}

/// Fills the slots of one run in memory, homes included; counters give tasks per second and shares of the time.
void fill_slots(benchmark::State& state) {
  const auto& reading = committed();
  if (!reading.errors.empty()) return state.SkipWithError(format(reading.errors.front()).c_str());
  RunConfiguration configuration;
  configuration.count = static_cast<int>(state.range(0));
  const auto slots = plan_slots(configuration, reading.resources);
  if (!slots) return state.SkipWithError(format(slots.error()).c_str());
  StageCosts costs;
  double tasks = 0, candidates = 0, bytes = 0;
  for (auto _ : state) {
    LayoutPool layouts(configuration, reading.resources);
    CandidatePlanner planner(configuration, reading.resources, layouts, *slots);
    Frequencies taken;
    std::vector<int> open;
    for (const auto& slot : *slots) open.push_back(slot.index);
    for (int attempt = 0; attempt < configuration.attempts && !open.empty(); ++attempt) {
      std::vector<int> still_open;
      for (const auto& plan : planner.round(open, attempt, taken)) {
        const auto& slot = (*slots)[static_cast<std::size_t>(plan.slot)];
        const auto candidate =
            make_task(configuration, reading.resources, layouts, slot, plan, planner.counts(), &costs);
        const auto start = std::chrono::steady_clock::now();
        const auto record = record_of(candidate);
        costs.seconds[static_cast<std::size_t>(Stage::Writer)] +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        ++candidates;
        bytes += static_cast<double>(record.task.size() + record.demonstration.size() + record.scene.size());
        if (record.accepted) {
          ++tasks;
          taken.add(traits_from(record.traits));
        } else {
          still_open.push_back(plan.slot);
        }
      }
      open = still_open;
    }
  }
  state.counters["tasks/s"] = benchmark::Counter(tasks, benchmark::Counter::kIsRate);
  state.counters["yield"] = tasks / candidates;
  state.counters["kB/task"] = bytes / tasks / 1000;
  double staged = 0;
  for (const double seconds : costs.seconds) staged += seconds;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    if (costs.seconds[i] > 0)
      state.counters["share_" + std::string(name_of(static_cast<Stage>(i)))] = costs.seconds[i] / staged;
  }
}
BENCHMARK(fill_slots)->Arg(40)->Arg(200)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
