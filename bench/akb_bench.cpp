// Compiling all knowledge must stay below a second, loading one simulator below 50 ms.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "akb/knowledge.h"

namespace {

using namespace unietp;

const std::filesystem::path kTables = std::filesystem::path(UNIETP_SOURCE_DIR) / "data" / "akb";
std::filesystem::path database() { return std::filesystem::temp_directory_path() / "unietp_akb_bench.sqlite"; }

void compile_all(benchmark::State& state) {
  for (auto _ : state) {
    if (!compile_knowledge(kTables, database()).empty()) state.SkipWithError("the tables do not compile");
  }
}
BENCHMARK(compile_all)->Unit(benchmark::kMillisecond);

void load_one(benchmark::State& state) {
  if (!compile_knowledge(kTables, database()).empty()) state.SkipWithError("the tables do not compile");
  for (auto _ : state) {
    auto knowledge = load_knowledge(database(), kSimulators[static_cast<std::size_t>(state.range(0))]);
    if (!knowledge) state.SkipWithError("the database does not load");
    benchmark::DoNotOptimize(knowledge);
  }
}
BENCHMARK(load_one)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void queries(benchmark::State& state) {
  if (!compile_knowledge(kTables, database()).empty()) state.SkipWithError("the tables do not compile");
  const auto knowledge = load_knowledge(database(), Simulator::Behavior);
  for (auto _ : state) {
    for (const auto& c : knowledge->categories()) {
      benchmark::DoNotOptimize(knowledge->has(c.name, "pickupable"));
      benchmark::DoNotOptimize(knowledge->placement(c.name, "on", "countertop"));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(2 * knowledge->categories().size()));
}
BENCHMARK(queries);

}  // namespace

BENCHMARK_MAIN();
