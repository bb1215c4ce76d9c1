// The whole path of a task on one core, from the template to the bytes of a published data set, and what share of it
// each stage takes: the baseline that later work is compared with (docs/evidence.md).
#include <chrono>
#include <filesystem>
#include <optional>

#include <benchmark/benchmark.h>
#include <unistd.h>

#include "bench/reference_work.h"
#include "grounding/floor_plan.h"
#include "grounding/layout.h"
#include "grounding/reachability.h"
#include "pipeline/run.h"

namespace {

using namespace unietp;

ResourcesReading committed() {
  return load_resources({UNIETP_SOURCE_DIR, std::filesystem::temp_directory_path() / "unietp-bench-cache"});
}

/// One whole run a pass, homes and files included. Counters by processor time: tasks a second, the same without what it
/// took to draw and prepare the homes, and a reference work; yield; share of each stage, and of what is in none.
void run(benchmark::State& state, const RunConfiguration& configuration, const Resources& resources) {
  const auto folder = std::filesystem::temp_directory_path() / ("unietp-pipeline-bench-" + std::to_string(::getpid()));
  StageCosts costs;
  double tasks = 0, candidates = 0, seconds = 0, elapsed = 0;
  for (auto _ : state) {
    RunOptions options;
    options.out = folder / "set";
    options.licences = std::filesystem::path(UNIETP_SOURCE_DIR) / "data/licences.csv";
    options.costs = &costs;
    const auto clock = std::chrono::steady_clock::now();
    const double start = processor_seconds();
    const auto report = run_generation(configuration, resources, options);
    seconds += processor_seconds() - start;
    elapsed += std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
    std::filesystem::remove_all(folder);
    if (!report) return state.SkipWithError(format(report.error()).c_str());
    tasks += report->tasks;
    candidates += report->candidates;
  }
  state.counters["tasks/s"] = tasks / seconds;
  const double homes =
      costs.seconds[static_cast<std::size_t>(Stage::Homes)] / elapsed;  // stages are timed by the clock
  state.counters["tasks/s_in_given_homes"] = tasks / seconds / (1 - homes);
  state.counters["tasks/reference"] = tasks / seconds * reference_seconds();
  state.counters["yield"] = tasks / candidates;
  state.counters["ms/candidate"] = 1000 * seconds / candidates;
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

/// Where the lower wall of a home can have a gap with free floor behind it: the room, and the gap's first corner.
std::optional<std::pair<std::size_t, Vec2>> door_below(const Scene& home, const NavigationGrid& grid, double low) {
  for (std::size_t room = 0; room < home.rooms.size(); ++room) {
    const Bounds bounds = room_bounds(home.rooms[room], home.wall_height);
    if (bounds.low.y() > low + 1e-9) continue;
    for (double x = bounds.low.x() + 0.3; x + kOpeningWidth_m < bounds.high.x() - 0.3; x += 0.1) {
      bool free = true;
      for (double dx = 0.3; dx <= 0.7; dx += 0.1) {
        for (double dy = 0.3; dy < 1; dy += 0.1) free = free && grid.free(grid.cell_at({x + dx, low + dy}));
      }
      if (free) return std::pair(room, Vec2(x, low));
    }
  }
  return std::nullopt;
}

/// The home so many times in a row, every one with a door to one long corridor below them.
std::optional<Scene> street_of(const Scene& home, int copies, const Profile& profile) {
  constexpr double kCorridor_m = 1.6;
  Vec2 low = home.rooms.front().polygon.front(), high = low;
  for (const Room& room : home.rooms) {
    for (const Vec2& corner : room.polygon) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
  }
  const auto door = door_below(home, NavigationGrid(home, profile), low.y());
  if (!door) return std::nullopt;
  Scene street = home;
  street.rooms.clear(), street.openings.clear(), street.nodes.clear(), street.edges.clear();
  for (int copy = 0; copy < copies; ++copy) {
    const Vec2 shift(copy * (high.x() - low.x()), 0);
    const auto renamed = [&](const std::string& id) { return id + "_" + std::to_string(copy); };
    for (Room room : home.rooms) {
      room.id = renamed(room.id);
      for (Vec2& corner : room.polygon) corner += shift;
      street.rooms.push_back(room);
    }
    for (Opening opening : home.openings) {
      for (auto* id : {&opening.id, &opening.room_a, &opening.room_b}) *id = renamed(*id);
      opening.from += shift, opening.to += shift;
      street.openings.push_back(opening);
    }
    for (Node node : home.nodes) {
      node.id = renamed(node.id);
      node.pose.position.head<2>() += shift;
      street.nodes.push_back(node);
    }
    const Vec2 from = door->second + shift;
    street.openings.push_back({renamed("front_door"), renamed(home.rooms[door->first].id), "street", from,
                               from + Vec2(kOpeningWidth_m, 0), 2.0});
  }
  const double end = low.x() + copies * (high.x() - low.x()), below = low.y() - kCorridor_m;
  street.rooms.push_back({"street", "corridor", {{low.x(), below}, {end, below}, {end, low.y()}, {low.x(), low.y()}}});
  return street;
}

/// What a candidate costs in one home of so many objects, which is not drawn for the clock: a home of 210 objects, or
/// a street of such homes.
void one_home_of_objects(benchmark::State& state) {
  auto reading = committed();
  if (!reading.errors.empty()) return state.SkipWithError(format(reading.errors.front()).c_str());
  const auto& backend = reading.resources.backend(Simulator::Ai2thor);
  RunConfiguration configuration;
  configuration.count = 400;
  configuration.simulators = {Simulator::Ai2thor};
  LayoutOptions options;
  options.rooms = 7;
  options.objects = 210;
  const int copies = static_cast<int>(state.range(0)) / options.objects;
  for (std::uint64_t seed = 1; reading.resources.homes.empty() && seed < 20; ++seed) {
    const auto home = generate_layout(reading.resources.recipe(Simulator::Ai2thor), backend.knowledge, backend.profile,
                                      options, "home", Rng(seed));
    if (!home) continue;
    auto street = street_of(*home, copies, backend.profile);
    if (street && !unreached_room(*street, walk_in(*street, backend.profile)))
      reading.resources.homes.push_back(std::move(*street));
  }
  if (reading.resources.homes.empty()) return state.SkipWithError("no street with a door to every home");
  configuration.scenes = {reading.resources.homes.front().id};
  state.counters["objects"] = static_cast<double>(reading.resources.homes.front().nodes.size());
  run(state, configuration, reading.resources);
}
BENCHMARK(one_home_of_objects)->Arg(210)->Arg(1050)->Arg(5040)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
