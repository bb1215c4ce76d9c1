// What the backend's parts cost, on a room of many bodies. Ratios to compare: a settle against building all bodies, the
// links around one thing against reading all, steps against making a world, and against doing them again.
#include <cstdint>

#include <benchmark/benchmark.h>

#include "simulation/known_start.h"
#include "simulation/navigation.h"
#include "simulation/relations.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

/// The test kitchen in a row, eleven objects each.
Scene street(std::int64_t kitchens) {
  const Scene one = testing::kitchen();
  Scene all = one;
  for (std::int64_t k = 1; k < kitchens; ++k) {
    const Vec3 shift(6.0 * static_cast<double>(k), 0, 0);
    Room room = one.rooms.front();
    room.id = "kitchen_" + std::to_string(k + 1);
    for (Vec2& corner : room.polygon) corner += shift.head<2>();
    all.rooms.push_back(room);
    for (Node node : one.nodes) {
      node.id.append("_").append(std::to_string(k));
      node.pose.position += shift;
      all.nodes.push_back(node);
    }
  }
  all.edges = read_relations(all);
  return all;
}

struct Fixture {
  explicit Fixture(std::int64_t kitchens = 10) : scene(street(kitchens)) {}
  Knowledge knowledge = testing::kitchen_knowledge();
  Profile profile = testing::kitchen_profile();
  Scene scene;
  PhysicsWorld physics = physics_of(scene);
  KnownStart known() const { return {.physics = physics}; }
};

void BuildAllBodies(benchmark::State& state) {
  const Fixture f;
  for (auto _ : state) benchmark::DoNotOptimize(physics_of(f.scene).has(BodyId::node(0)));
}
void ReadAllRelations(benchmark::State& state) {
  const Fixture f;
  for (auto _ : state) benchmark::DoNotOptimize(read_relations(f.scene, f.physics));
}
void ReadLinksAroundOne(benchmark::State& state) {
  const Fixture f;
  const Bounds touched[] = {f.physics.bounds(BodyId::node(6))};
  const std::size_t changed[] = {6};
  for (auto _ : state) {
    for (const std::size_t i : affected_by(f.physics, touched, changed))
      benchmark::DoNotOptimize(links_of(f.scene, f.physics, i));
  }
}
/// Each time from a place where nothing was settled before.
void SettleOne(benchmark::State& state) {
  Fixture f;
  const BodyId loose[] = {BodyId::node(6)};
  Pose pose = f.scene.nodes[6].pose;
  for (auto _ : state) {
    pose.position.x() += 1e-9;
    f.physics.move(BodyId::node(6), pose);
    benchmark::DoNotOptimize(f.physics.settle(loose).calm);
  }
}
void Grid(benchmark::State& state) {
  const Fixture f;
  for (auto _ : state) benchmark::DoNotOptimize(NavigationGrid(f.scene, f.profile).free({3, 3}));
}
void CopyWorld(benchmark::State& state) {
  const Fixture f;
  const World world = *World::create(f.scene, f.knowledge, f.profile);
  for (auto _ : state) benchmark::DoNotOptimize(World(world).stopped());
}
/// Of a start whose bodies are known.
void CreateWorld(benchmark::State& state) {
  const Fixture f(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(World::create(f.scene, f.knowledge, f.profile, f.known())->stopped());
}

bool fetch_and_place(World& world) {
  bool ok = true;
  for (const Action& action :
       {Action{ActionType::GoTo, {"mug_1"}}, Action{ActionType::PickUp, {"mug_1"}},
        Action{ActionType::GoTo, {"countertop_1"}}, Action{ActionType::PlaceOn, {"countertop_1"}}}) {
    ok = ok && world.step(action).success;
  }
  return ok;
}
/// Four steps in a world of their own each time, less the making of it.
void FetchAndPlace(benchmark::State& state) {
  const Fixture f(state.range(0));
  for (auto _ : state) {
    state.PauseTiming();
    World world = *World::create(f.scene, f.knowledge, f.profile, f.known());
    (void)world.standing_place_for("mug_1");  // the walk grid is the home's
    state.ResumeTiming();
    if (!fetch_and_place(world)) state.SkipWithError("the plan failed");
    state.PauseTiming();
    world = *World::create(testing::kitchen(), f.knowledge, f.profile);  // the end of the old one is not measured
    state.ResumeTiming();
  }
}
/// What a mutant pays for the steps that it has in common with another.
void FetchAndPlaceAgain(benchmark::State& state) {
  const Fixture f;
  const World start = *World::create(f.scene, f.knowledge, f.profile);
  for (auto _ : state) {
    World world = start;
    if (!fetch_and_place(world)) state.SkipWithError("the plan failed");
  }
}

BENCHMARK(BuildAllBodies)->Unit(benchmark::kMicrosecond);
BENCHMARK(ReadAllRelations)->Unit(benchmark::kMicrosecond);
BENCHMARK(ReadLinksAroundOne)->Unit(benchmark::kMicrosecond);
BENCHMARK(SettleOne)->Unit(benchmark::kMicrosecond);
BENCHMARK(Grid)->Unit(benchmark::kMicrosecond);
BENCHMARK(CopyWorld)->Unit(benchmark::kMicrosecond);
BENCHMARK(CreateWorld)->Arg(10)->Arg(20)->Arg(450)->Unit(benchmark::kMicrosecond);
BENCHMARK(FetchAndPlace)->Arg(10)->Arg(20)->Arg(450)->Unit(benchmark::kMicrosecond);
BENCHMARK(FetchAndPlaceAgain)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace unietp

BENCHMARK_MAIN();
