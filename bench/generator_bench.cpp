// The gate must cost less than a millisecond a candidate. `propose` sends bindings of all templates on all simulators
// through it, on the committed tables; the counter `ratio` holds it against `read_goals`, which only writes the same
// goals and start constraints as text and reads them again: what a file of finished candidates would cost. `us_slowest`
// is the slowest candidate of all, named beside it.
#include <benchmark/benchmark.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>

#include "generator/propose.h"

namespace {

using namespace unietp;
namespace fs = std::filesystem;

constexpr std::uint64_t kBindings = 6;  // of each template on each simulator that it claims

/// Processor time of this process, seconds: other work on the machine does not count.
double used() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Candidate {
  const Template* source = nullptr;
  const Knowledge* knowledge = nullptr;
  Binding binding;
};

struct Committed {
  std::vector<Template> templates;
  std::map<Simulator, Knowledge> knowledge;
  std::vector<Candidate> candidates;
  std::vector<Specification> specifications;  // of the candidates that pass
};

/// Templates and tables must not move afterwards: candidates point to them.
std::unique_ptr<Committed> read_committed() {
  auto read = std::make_unique<Committed>();
  const fs::path folder = UNIETP_SOURCE_DIR;
  for (const char* name : {"library", "extended"}) {
    auto library = load_templates(folder / "templates" / name);
    if (!library.errors.empty()) throw std::runtime_error(format(library.errors.front()));
    for (auto& source : library.templates) read->templates.push_back(std::move(source));
  }
  const auto database = fs::temp_directory_path() / ("unietp_bench_" + std::to_string(::getpid()) + ".sqlite");
  if (const auto errors = compile_knowledge(folder / "data/akb", database); !errors.empty())
    throw std::runtime_error(format(errors.front()));
  for (const auto simulator : kSimulators) {
    auto loaded = load_knowledge(database, simulator);
    if (!loaded) throw std::runtime_error(format(loaded.error()));
    read->knowledge.emplace(simulator, std::move(*loaded));
  }
  fs::remove(database);
  for (const auto& source : read->templates) {
    for (const auto simulator : source.simulators) {
      const auto& knowledge = read->knowledge.at(simulator);
      for (std::uint64_t seed = 0; seed < kBindings; ++seed) {
        const auto binding = sample_binding(source, knowledge, {}, Rng(seed).fork(source.name, 0));
        if (!binding) break;
        read->candidates.push_back({&source, &knowledge, *binding});
        auto proposed = propose(source, knowledge, *binding);
        if (auto* made = std::get_if<Specification>(&proposed)) read->specifications.push_back(std::move(*made));
      }
    }
  }
  return read;
}

const Committed& committed() {
  static const auto kRead = read_committed();
  return *kRead;
}

void read_goals(const Committed& all) {
  const auto read = [](const Formula& formula, FormulaUse use) {
    auto again = parse_formula("bench", to_text(formula), use);
    benchmark::DoNotOptimize(again);
  };
  for (const auto& made : all.specifications) {
    read(made.goal, FormulaUse::Goal);
    for (const auto& start : made.init) read(start, FormulaUse::State);
  }
}

void gate(benchmark::State& state) {
  const auto& all = committed();
  double gate_s = 0, baseline_s = 0;
  std::vector<double> least_s(all.candidates.size(), 1e9);  // of all rounds, so that no interruption counts
  for (auto _ : state) {
    for (std::size_t i = 0; i < all.candidates.size(); ++i) {
      const auto& candidate = all.candidates[i];
      const double before = used();
      auto proposed = propose(*candidate.source, *candidate.knowledge, candidate.binding);
      benchmark::DoNotOptimize(proposed);
      const double took = used() - before;
      gate_s += took;
      least_s[i] = std::min(least_s[i], took);
    }
    const double before = used();
    read_goals(all);
    baseline_s += used() - before;
  }
  const auto rounds = static_cast<double>(state.iterations());
  state.counters["candidates"] = static_cast<double>(all.candidates.size());
  state.counters["us_each"] = 1e6 * gate_s / rounds / static_cast<double>(all.candidates.size());
  const auto slowest = std::max_element(least_s.begin(), least_s.end());
  const auto& candidate = all.candidates[static_cast<std::size_t>(slowest - least_s.begin())];
  std::string label = candidate.source->name + " on " + std::string(name_of(candidate.knowledge->simulator()));
  for (const auto& [placeholder, category] : candidate.binding) label += " " + placeholder + "=" + category;
  state.SetLabel("slowest: " + label);
  state.counters["us_slowest"] = 1e6 * *slowest;
  state.counters["ratio"] =
      gate_s / baseline_s * static_cast<double>(all.specifications.size()) / static_cast<double>(all.candidates.size());
}
BENCHMARK(gate)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
