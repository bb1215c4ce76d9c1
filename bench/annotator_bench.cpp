// Instructions a second on one core, checks included, for tasks of the whole library on one simulator.
#include <filesystem>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "annotator/equivalence.h"
#include "annotator/instruction.h"
#include "annotator/word_check.h"
#include "templates/template.h"

namespace {

using namespace unietp;

struct Material {
  Knowledge knowledge;
  NounTable nouns;
  std::vector<Specification> tasks;
};

const Material& material() {
  static const Material kMaterial = [] {
    const std::filesystem::path root(UNIETP_SOURCE_DIR);
    const auto database = std::filesystem::temp_directory_path() / "unietp-annotator-bench.sqlite";
    (void)compile_knowledge(root / "data/akb", database);
    auto knowledge = *load_knowledge(database, Simulator::Ai2thor);
    std::vector<Error> errors;
    NounTable nouns(knowledge, read_everyday_names(root / "data/english", errors));
    if (!errors.empty()) throw std::runtime_error(format(errors.front()));
    std::vector<Specification> tasks;
    for (const Template& source : load_templates(root / "templates/library").templates) {
      const auto binding = sample_binding(source, knowledge, {}, Rng(3));
      if (!binding) continue;
      if (auto task = instantiate(source, knowledge, *binding)) tasks.push_back(std::move(*task));
    }
    return Material{std::move(knowledge), std::move(nouns), std::move(tasks)};
  }();
  return kMaterial;
}

void write_and_check(benchmark::State& state) {
  const Material& all = material();
  const auto phrasings = static_cast<Phrasings>(state.range(0));
  std::uint64_t seed = 0;
  std::int64_t failed = 0;
  for (auto _ : state) {
    const Specification& task = all.tasks[seed % all.tasks.size()];
    const auto text = write_instruction(task, all.knowledge, all.nouns, {phrasings, {}}, Rng(seed++));
    failed += text ? 0 : 1;
    benchmark::DoNotOptimize(text);
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["without words"] = static_cast<double>(failed);
}
BENCHMARK(write_and_check)
    ->ArgName("phrasings")
    ->Arg(static_cast<int>(Phrasings::All))
    ->Arg(static_cast<int>(Phrasings::Training))
    ->Arg(static_cast<int>(Phrasings::Benchmark));

/// What a text of a language model goes through besides the two calls.
void check_words(benchmark::State& state) {
  const Material& all = material();
  const Specification& task = all.tasks[static_cast<std::size_t>(state.range(0))];
  const auto text = write_instruction(task, all.knowledge, all.nouns, {}, Rng(1));
  if (!text) return state.SkipWithError("no words");
  for (auto _ : state) benchmark::DoNotOptimize(saying_faults(text->text, task, all.nouns));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(check_words)->Arg(0)->Arg(40);

/// Goals that no proof by structure joins: as many traces as a comparison takes at most.
void compare_by_traces(benchmark::State& state) {
  const Formula& goal = material().tasks[static_cast<std::size_t>(state.range(0))].goal;
  for (auto _ : state) benchmark::DoNotOptimize(distinguishing_trace(goal, goal, kTracesCompared, Rng(1)));
  state.SetItemsProcessed(state.iterations() * kTracesCompared);
}
BENCHMARK(compare_by_traces)->Arg(0)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
