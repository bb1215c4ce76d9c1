#include <benchmark/benchmark.h>

#include <unistd.h>

#include "grounding/collision.h"
#include "grounding/ground.h"
#include "grounding/layout.h"

namespace unietp {
namespace {

struct Surroundings {
  Knowledge knowledge;
  LayoutRecipe recipe;
  Profile profile;
};

Surroundings load(Simulator simulator) {
  const std::filesystem::path root = UNIETP_SOURCE_DIR;
  const auto file = std::filesystem::temp_directory_path() / ("unietp_bench_" + std::to_string(::getpid()) + ".sqlite");
  compile_knowledge(root / "data/akb", file);
  auto knowledge = load_knowledge(file, simulator);
  std::filesystem::remove(file);
  auto recipe = load_recipe(root / "data/layouts", *knowledge);
  return {std::move(*knowledge), std::move(*recipe), *load_profile(root / "data/simulators", simulator)};
}

/// A home as the benchmark's are, of 7 rooms and 210 objects, over 16 seeds; time for one. Arguments: the simulator,
/// and whether each object is let down in physics. What takes the time is told in docs/scenes.md.
void BM_GenerateLayout(benchmark::State& state) {
  const auto simulator = kSimulators[static_cast<std::size_t>(state.range(0))];
  const Surroundings style = load(simulator);
  LayoutOptions options;
  options.rooms = 7;
  options.objects = 210;
  options.settle = state.range(1) != 0;
  state.SetLabel(std::string(name_of(simulator)) + (options.settle ? ", settled" : ", not settled"));
  std::uint64_t seed = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        generate_layout(style.recipe, style.knowledge, style.profile, options, "home", Rng(seed++ % 16)));
  }
}
BENCHMARK(BM_GenerateLayout)->ArgsProduct({{0, 1, 2, 3}, {0, 1}})->Unit(benchmark::kMillisecond)->MinTime(2);

/// One specification that adds, moves and changes things.
void BM_Ground(benchmark::State& state) {
  const Surroundings style = load(Simulator::Ai2thor);
  const Home home =
      prepare_home(*generate_layout(style.recipe, style.knowledge, style.profile, {}, "home", Rng(2)), style.profile);
  Specification spec;
  spec.goal =
      *parse_formula("bench", "(exists (?a - Mug) (exists (?b - DiningTable) (at-end (on ?a ?b))))", FormulaUse::Goal);
  for (const char* init : {"(count >= 3 (?a - Mug) (dirty ?a))", "(count >= 1 (?a - Mug) (clean ?a))",
                           "(forall (?a - Mug) (not (exists (?b - DiningTable) (on ?a ?b))))"}) {
    spec.init.push_back(*parse_formula("bench", init, FormulaUse::State));
  }
  std::uint64_t seed = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ground(spec, home, style.knowledge, style.profile, {}, Rng(seed++ % 16)));
  }
}
BENCHMARK(BM_Ground)->Unit(benchmark::kMillisecond);

/// One placement attempt against a furnished home, by FCL.
void BM_PlacementCheck(benchmark::State& state) {
  const Surroundings style = load(Simulator::Ai2thor);
  const auto home = generate_layout(style.recipe, style.knowledge, style.profile, {}, "home", Rng(2));
  PlacementChecker checker;
  for (std::size_t i = 0; i < home->nodes.size(); ++i) {
    const Node& node = home->nodes[i];
    checker.set(BodyId::node(i), shape_of(node), node.pose, node.opening);
  }
  const Shape probe = make_shape(Archetype::Box, {0.1, 0.1, 0.1}, false);
  Rng rng(1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        checker.hit(probe, upright({rng.uniform(0, 9), rng.uniform(0, 9), rng.uniform(0, 1.5)}, rng.unit()), 0));
  }
}
BENCHMARK(BM_PlacementCheck);

}  // namespace
}  // namespace unietp

BENCHMARK_MAIN();
