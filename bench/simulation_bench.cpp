// What the backend's parts cost, on a room of many bodies. Ratios to compare: a settle against building all bodies, an
// update of the relations against reading them all, a step against a copy of the world.
#include <benchmark/benchmark.h>

#include "simulation/navigation.h"
#include "simulation/relations.h"
#include "simulation/world.h"
#include "tests/simulation/kitchen.h"

namespace unietp {
namespace {

/// The test kitchen in a row of ten: 110 objects.
Scene street() {
  const Scene one = testing::kitchen();
  Scene all = one;
  for (int k = 1; k < 10; ++k) {
    const Vec3 shift(6.0 * k, 0, 0);
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
  Knowledge knowledge = testing::kitchen_knowledge();
  Profile profile = testing::kitchen_profile();
  Scene scene = street();
  PhysicsWorld physics = physics_of(scene);
};

void BuildAllBodies(benchmark::State& state) {
  const Fixture f;
  for (auto _ : state) benchmark::DoNotOptimize(physics_of(f.scene).has(0));
}
void ReadAllRelations(benchmark::State& state) {
  const Fixture f;
  for (auto _ : state) benchmark::DoNotOptimize(read_relations(f.scene, f.physics));
}
void UpdateRelationsOfOne(benchmark::State& state) {
  const Fixture f;
  const Bounds touched[] = {f.physics.bounds(6)};
  const std::size_t changed[] = {6};
  for (auto _ : state) benchmark::DoNotOptimize(update_relations(f.scene, f.physics, {}, touched, changed));
}
void SettleOne(benchmark::State& state) {
  const Fixture f;
  const BodyId loose[] = {6};
  for (auto _ : state) benchmark::DoNotOptimize(f.physics.settle(loose).calm);
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
void FetchAndPlace(benchmark::State& state) {
  const Fixture f;
  const World start = *World::create(f.scene, f.knowledge, f.profile);
  for (auto _ : state) {
    World world = start;
    bool ok = true;
    for (const Action& action :
         {Action{ActionType::GoTo, {"mug_1"}}, Action{ActionType::PickUp, {"mug_1"}},
          Action{ActionType::GoTo, {"countertop_1"}}, Action{ActionType::PlaceOn, {"countertop_1"}}}) {
      ok = ok && world.step(action).success;
    }
    if (!ok) state.SkipWithError("the plan failed");
  }
}

BENCHMARK(BuildAllBodies)->Unit(benchmark::kMicrosecond);
BENCHMARK(ReadAllRelations)->Unit(benchmark::kMicrosecond);
BENCHMARK(UpdateRelationsOfOne)->Unit(benchmark::kMicrosecond);
BENCHMARK(SettleOne)->Unit(benchmark::kMicrosecond);
BENCHMARK(Grid)->Unit(benchmark::kMicrosecond);
BENCHMARK(CopyWorld)->Unit(benchmark::kMicrosecond);
BENCHMARK(FetchAndPlace)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace unietp

BENCHMARK_MAIN();
