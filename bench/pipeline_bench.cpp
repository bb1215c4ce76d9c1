// The whole path of a task on one core, from the template to the bytes of a published data set, and what share of it
// each stage takes: the baseline that later work is compared with (docs/evidence.md).
#include <ctime>
#include <filesystem>
#include <map>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "grounding/layout.h"
#include "pipeline/run.h"

namespace {

using namespace unietp;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Seconds for a fixed piece of work of the standard library alone: what a run takes is told in these too, so that
/// runs of different hours or machines can be compared.
double reference_seconds() {
  const double start = processor_seconds();
  std::map<std::string, double> table;
  Rng rng(1);
  for (int i = 0; i < 100'000; ++i) table.emplace("object_" + std::to_string(rng.next()), rng.unit());
  double sum = 0;
  for (const auto& [name, value] : table) sum += value;
  benchmark::DoNotOptimize(sum);
  return processor_seconds() - start;
}

ResourcesReading committed() {
  return load_resources({UNIETP_SOURCE_DIR, std::filesystem::temp_directory_path() / "unietp-bench-cache"});
}

/// One whole run a pass, homes and files included. Counters by processor time: tasks a second, and a reference work;
/// yield; share of each stage, and of what is in none.
void run(benchmark::State& state, const RunConfiguration& configuration, const Resources& resources) {
  const auto folder = std::filesystem::temp_directory_path() / ("unietp-pipeline-bench-" + std::to_string(::getpid()));
  StageCosts costs;
  double tasks = 0, candidates = 0, seconds = 0, elapsed = 0;
  for (auto _ : state) {
    RunOptions options;
    options.out = folder / "set";
    options.licences = std::filesystem::path(UNIETP_SOURCE_DIR) / "data/licences.csv";
    options.costs = &costs;
    const double start = processor_seconds();
    const auto report = run_generation(configuration, resources, options);
    seconds += processor_seconds() - start;
    std::filesystem::remove_all(folder);
    if (!report) return state.SkipWithError(format(report.error()).c_str());
    tasks += report->tasks;
    candidates += report->candidates;
    elapsed += report->seconds;
  }
  state.counters["tasks/s"] = tasks / seconds;
  state.counters["tasks/reference"] = tasks / seconds * reference_seconds();
  state.counters["yield"] = tasks / candidates;
  state.counters["ms/candidate"] = 1000 * seconds / candidates;
  const auto of = [&](Stage stage) { return costs.seconds[static_cast<std::size_t>(stage)]; };
  elapsed += of(Stage::Dataset);  // the report is made before
  double in_none = elapsed;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    in_none -= costs.seconds[i];
    state.counters["share_" + std::string(name_of(static_cast<Stage>(i)))] = costs.seconds[i] / elapsed;
  }
  state.counters["share_of_none"] = in_none / elapsed;
}

/// All simulators and splits, homes drawn as a run of that size draws them.
void whole_run(benchmark::State& state) {
  const auto reading = committed();
  if (!reading.errors.empty()) return state.SkipWithError(format(reading.errors.front()).c_str());
  RunConfiguration configuration;
  configuration.count = static_cast<int>(state.range(0));
  run(state, configuration, reading.resources);
}
BENCHMARK(whole_run)->Arg(40)->Arg(200)->Arg(1000)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Tasks in one home of so many objects, which is not drawn for the clock: what a candidate costs in it.
void one_home_of_objects(benchmark::State& state) {
  auto reading = committed();
  if (!reading.errors.empty()) return state.SkipWithError(format(reading.errors.front()).c_str());
  RunConfiguration configuration;
  configuration.count = 100;
  configuration.simulators = {Simulator::Ai2thor};
  const auto& backend = reading.resources.backend(Simulator::Ai2thor);
  LayoutOptions options;
  options.objects = static_cast<int>(state.range(0));
  options.rooms = options.objects / 30;
  options.settle = false;
  auto home = generate_layout(reading.resources.recipe(Simulator::Ai2thor), backend.knowledge, backend.profile, options,
                              "home", Rng(1));
  if (!home) return state.SkipWithError(format(home.error()).c_str());
  state.counters["objects"] = static_cast<double>(home->nodes.size());
  configuration.scenes = {home->id};
  reading.resources.homes = {std::move(*home)};
  run(state, configuration, reading.resources);
}
BENCHMARK(one_home_of_objects)->Arg(210)->Arg(1000)->Arg(5000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
