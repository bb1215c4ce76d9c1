// What an agent's episodes cost on one core, in homes of the training pool of about 210 objects, for each simulator:
// resets, new tasks, steps with boxes and with pictures, several threads, memory.
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "environment/batch.h"
#include "procedural/procedural.h"
#include "tests/environment/random_agent.h"

namespace {

using namespace unietp;

std::shared_ptr<const Resources> committed() {
  static const auto kReading = std::make_shared<const ResourcesReading>(
      load_resources({UNIETP_SOURCE_DIR, std::filesystem::temp_directory_path() / "unietp-bench-cache"}));
  return {kReading, &kReading->resources};
}

Procedural tasks_of(const benchmark::State& state, int homes) {
  ProceduralOptions options;
  options.simulators = {kSimulators[static_cast<std::size_t>(state.range(0))]};
  options.homes = homes;
  return *Procedural::make(committed(), options);
}

SharedTask first_task(benchmark::State& state, const Procedural& source) {
  auto task = source.task(1);
  state.SetLabel((*task)->text.layout + ", " + std::to_string((*task)->start.nodes.size()) + " objects");
  return *task;
}

Settings endless(Mode mode, int side = 0) {
  Settings settings = settings_for(mode);
  settings.rules.limits = {1'000'000, 1'000'000};
  settings.image_width = settings.image_height = side;
  return settings;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Processor time of all threads.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The same task again.
void BM_Reset(benchmark::State& state) {
  const Procedural source = tasks_of(state, 1);
  Environment environment = std::move(*Environment::make(first_task(state, source), settings_for(Mode::M1)));
  for (auto _ : state) benchmark::DoNotOptimize(environment.reset());
}

/// A new proven task in a home that has been made already, and its first observation.
void BM_NewTask(benchmark::State& state) {
  const Procedural source = tasks_of(state, 1);
  Environment environment = std::move(*Environment::make(first_task(state, source), settings_for(Mode::M1)));
  std::uint64_t seed = 2;
  for (auto _ : state) benchmark::DoNotOptimize(environment.reset(*source.task(seed++)));
}

/// The same with a home of its own, which is what the first task in each home costs.
void BM_NewHome(benchmark::State& state) {
  std::uint64_t seed = 2;
  for (auto _ : state) {
    ProceduralOptions options;
    options.simulators = {kSimulators[static_cast<std::size_t>(state.range(0))]};
    options.homes = 1;
    options.homes_seed = seed;
    benchmark::DoNotOptimize(Procedural::make(committed(), options)->task(seed++));
  }
}

/// Steps of an agent without a plan; its own time is left out. Arguments: simulator, mode, side of the picture or 0.
void BM_Step(benchmark::State& state) {
  const Procedural source = tasks_of(state, 1);
  const SharedTask task = first_task(state, source);
  const auto side = static_cast<int>(state.range(2));
  Environment environment =
      std::move(*Environment::make(task, endless(kModes[static_cast<std::size_t>(state.range(1))], side)));
  testing::RandomAgent agent{Rng(1)};
  int steps = 0;
  for (auto _ : state) {
    if (++steps % 50 == 0) environment.reset();
    const std::string said = agent.answer(environment);
    const auto start = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(environment.step(said));
    if (side > 0) benchmark::DoNotOptimize(environment.picture());
    state.SetIterationTime(seconds_since(start));
  }
  state.SetItemsProcessed(state.iterations());
}

/// Environments of one home on some threads. Arguments: simulator, how many environments, threads. The processor time
/// of all threads in a step, which other programs change less than its wall time, tells what working side by side
/// costs.
void BM_Batch(benchmark::State& state) {
  const Procedural source = tasks_of(state, 1);
  const SharedTask task = first_task(state, source);
  const auto count = static_cast<std::size_t>(state.range(1));
  auto batch = std::move(*EnvironmentBatch::make(count, static_cast<int>(state.range(2)), endless(Mode::M1),
                                                 [&](std::size_t, std::uint64_t) { return Result<SharedTask>(task); }));
  std::vector<testing::RandomAgent> agents;
  for (std::size_t i = 0; i < count; ++i) agents.emplace_back(Rng(1).fork("agent", i));
  double busy = 0;
  for (auto _ : state) {
    std::vector<std::string> said;
    for (std::size_t i = 0; i < count; ++i) said.push_back(agents[i].answer(batch.at(i)));
    const auto start = std::chrono::steady_clock::now();
    const double busy_before = processor_seconds();
    (void)batch.step(said, [](std::size_t, const StepResult& step) { benchmark::DoNotOptimize(step.reward); });
    busy += processor_seconds() - busy_before;
    state.SetIterationTime(seconds_since(start));
  }
  state.counters["CPU_ms"] = benchmark::Counter(1000 * busy, benchmark::Counter::kAvgIterations);
  state.SetItemsProcessed(static_cast<std::int64_t>(count) * state.iterations());
}

double resident_MB() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Memory of each further environment of one task after 50 steps.
void BM_Memory(benchmark::State& state) {
  const Procedural source = tasks_of(state, 1);
  const SharedTask task = first_task(state, source);
  constexpr int kCount = 200;  // so many that memory which was free before counts for little
  for (auto _ : state) {
    std::vector<Environment> environments;
    const auto add = [&](std::uint64_t number) {
      environments.push_back(std::move(*Environment::make(task, endless(Mode::M2))));
      testing::RandomAgent agent(Rng(1).fork("agent", number));
      for (int i = 0; i < 50; ++i) (void)environments.back().step(agent.answer(environments.back()));
    };
    add(0);
    const double before = resident_MB();
    for (std::uint64_t i = 1; i <= kCount; ++i) add(i);
    state.counters["MB_each"] = (resident_MB() - before) / kCount;
  }
}

void simulators(benchmark::internal::Benchmark* bench) {
  for (int simulator = 0; simulator < 4; ++simulator) bench->Arg(simulator);
}

BENCHMARK(BM_Reset)->Apply(simulators)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_NewTask)->Apply(simulators)->Unit(benchmark::kMillisecond)->Iterations(60);
BENCHMARK(BM_NewHome)->Apply(simulators)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(BM_Step)->ArgsProduct({{0, 1, 2, 3}, {0, 1, 2}, {0}})->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Step)->ArgsProduct({{0, 1, 2, 3}, {0}, {300}})->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Batch)->ArgsProduct({{0, 1, 2, 3}, {32, 128}, {1, 2}})->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Memory)->Apply(simulators)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
