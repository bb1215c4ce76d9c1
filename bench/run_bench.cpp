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
#include "run/run.h"

namespace {

using namespace unietp;

ResourcesReading committed() {
  return load_resources({UNIETP_SOURCE_DIR, std::filesystem::temp_directory_path() / "unietp-bench-cache"});
}

/// What runs came to, homes and files included; by processor time, and stages by the clock.
struct Spent {
  StageCosts costs;
  double tasks = 0, candidates = 0, seconds = 0, elapsed = 0;

  double share(Stage stage) const { return costs.seconds[static_cast<std::size_t>(stage)] / elapsed; }
  /// Tasks a second without what it took to draw and prepare the homes.
  double rate_in_given_homes() const { return tasks / seconds / (1 - share(Stage::Homes)); }
};

std::optional<Error> add_run(const RunConfiguration& configuration, const Resources& resources, Spent& spent) {
  const auto folder = std::filesystem::temp_directory_path() / ("unietp-run-bench-" + std::to_string(::getpid()));
  RunOptions options;
  options.out = folder / "set";
  options.licenses = std::filesystem::path(UNIETP_SOURCE_DIR) / "data/licences.csv";
  options.costs = &spent.costs;
  const auto clock = std::chrono::steady_clock::now();
  const double start = processor_seconds();
  const auto report = run_generation(configuration, resources, options);
  spent.seconds += processor_seconds() - start;
  spent.elapsed += std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  std::filesystem::remove_all(folder);
  if (!report) return report.error();
  spent.tasks += report->tasks;
  spent.candidates += report->candidates;
  return std::nullopt;
}

/// One whole run a pass. Counters: tasks a second, the same in given homes, and a reference work; yield; share of each
/// stage, and of what is in none.
void run(benchmark::State& state, const RunConfiguration& configuration, const Resources& resources) {
  Spent spent;
  for (auto _ : state) {
    if (const auto error = add_run(configuration, resources, spent)) return state.SkipWithError(format(*error).c_str());
  }
  state.counters["tasks/s"] = spent.tasks / spent.seconds;
  state.counters["tasks/s_in_given_homes"] = spent.rate_in_given_homes();
  state.counters["tasks/reference"] = spent.tasks / spent.seconds * reference_seconds();
  state.counters["yield"] = spent.tasks / spent.candidates;
  state.counters["ms/candidate"] = 1000 * spent.seconds / spent.candidates;
  double of_none = 1;
  for (std::size_t i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    of_none -= spent.share(stage);
    state.counters["share_" + std::string(name_of(stage))] = spent.share(stage);
  }
  state.counters["share_of_none"] = of_none;
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

/// 400 tasks in one home of so many objects, which is not drawn for the clock: a home of 210 objects, or a street of
/// such homes.
struct OneHome {
  Resources resources;
  RunConfiguration configuration;
};

Result<OneHome> one_home_of(int objects) {
  auto reading = committed();
  if (!reading.errors.empty()) return reading.errors.front();
  OneHome one{std::move(reading.resources), {}};
  const auto& backend = one.resources.backend(Simulator::Ai2thor);
  one.configuration.count = 400;
  one.configuration.simulators = {Simulator::Ai2thor};
  LayoutOptions options;
  options.rooms = 7;
  options.objects = 210;
  for (std::uint64_t seed = 1; one.resources.homes.empty() && seed < 20; ++seed) {
    const auto home = generate_layout(one.resources.recipe(Simulator::Ai2thor), backend.knowledge, backend.profile,
                                      options, "home", Rng(seed));
    if (!home) continue;
    auto street = street_of(*home, objects / options.objects, backend.profile);
    if (street && !unreached_room(*street, walk_in(*street, backend.profile)))
      one.resources.homes.push_back(std::move(*street));
  }
  if (one.resources.homes.empty())
    return Error{Error::Kind::Unsatisfiable, "", {}, "no street with a door to every home"};
  one.configuration.scenes = {one.resources.homes.front().id};
  return one;
}

void one_home_of_objects(benchmark::State& state) {
  const auto one = one_home_of(static_cast<int>(state.range(0)));
  if (!one) return state.SkipWithError(format(one.error()).c_str());
  state.counters["objects"] = static_cast<double>(one->resources.homes.front().nodes.size());
  run(state, one->configuration, one->resources);
}
BENCHMARK(one_home_of_objects)->Arg(210)->Arg(1050)->Arg(5040)->Unit(benchmark::kMillisecond)->Iterations(1);

/// How many times what a kept task costs among 210 objects it costs among so many: both by turns, five times, since one
/// program varies from minute to minute by more than what is asked.
void cost_against_210_objects(benchmark::State& state) {
  const auto home = one_home_of(210), street = one_home_of(static_cast<int>(state.range(0)));
  for (const auto* one : {&home, &street}) {
    if (!*one) return state.SkipWithError(format(one->error()).c_str());
  }
  Spent at_home, in_street;
  for (auto _ : state) {
    auto error = add_run(home->configuration, home->resources, at_home);
    if (!error) error = add_run(street->configuration, street->resources, in_street);
    if (error) return state.SkipWithError(format(*error).c_str());
  }
  state.counters["times"] = at_home.rate_in_given_homes() / in_street.rate_in_given_homes();
  state.counters["tasks/s_at_210"] = at_home.rate_in_given_homes();
  state.counters["tasks/s"] = in_street.rate_in_given_homes();
}
BENCHMARK(cost_against_210_objects)->Arg(5040)->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace

BENCHMARK_MAIN();
