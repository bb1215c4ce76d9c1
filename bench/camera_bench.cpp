// What it costs to look, in a furnished home of 7 rooms and 210 objects, at 500 x 500 pixels, on one core. The baseline
// is one ray through every pixel (Segmentation); compare with it, not with the clock. Views are those of 16 drawn
// places where the body can stand.
#include <unistd.h>

#include <filesystem>

#include <benchmark/benchmark.h>

#include "core/png.h"
#include "grounding/layout.h"
#include "simulation/navigation.h"
#include "simulation/picture.h"
#include "simulation/solids.h"
#include "simulation/view.h"

namespace unietp {
namespace {

constexpr std::size_t kViews = 16;

struct Views {
  Profile profile;
  std::vector<Scene> scenes;
};

/// One home, seen from places drawn from those where the body can stand, level or a little down.
Views views_in(Simulator simulator) {
  const std::filesystem::path root = UNIETP_SOURCE_DIR;
  const auto file = std::filesystem::temp_directory_path() / ("unietp_bench_" + std::to_string(::getpid()) + ".sqlite");
  compile_knowledge(root / "data/akb", file);
  const auto knowledge = load_knowledge(file, simulator);
  std::filesystem::remove(file);
  const auto recipe = load_recipe(root / "data/layouts", *knowledge);
  Views views{*load_profile(root / "data/simulators", simulator), {}};
  views.profile.image_width = views.profile.image_height = 500;
  LayoutOptions options;
  options.rooms = 7;
  options.objects = 210;
  Rng rng(3);
  Scene home = *generate_layout(*recipe, *knowledge, views.profile, options, "home", rng.fork("home", 0));
  const NavigationGrid grid(home, views.profile);
  while (views.scenes.size() < kViews) {
    const NavigationGrid::Cell cell{static_cast<int>(rng.below(static_cast<std::uint64_t>(grid.width()))),
                                    static_cast<int>(rng.below(static_cast<std::uint64_t>(grid.height())))};
    if (!grid.free(cell)) continue;
    home.agent.position = grid.centre(cell);
    home.agent.yaw = 6.28 * rng.unit();
    home.agent.pitch = 0.5 * rng.unit();
    views.scenes.push_back(home);
  }
  return views;
}

const Views& views() {
  static const Views kViewsOfHome = views_in(Simulator::Ai2thor);
  return kViewsOfHome;
}

template <class Workplace, class Look>
void look_around(benchmark::State& state, Workplace workplace, Look look) {
  const Views& all = views();
  std::size_t i = 0;
  for (auto _ : state) look(all.scenes[i++ % kViews], all.profile, workplace);
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(i), benchmark::Counter::kIsRate);
}

void Segmentation(benchmark::State& state) {
  look_around(state, Rays(), [](const Scene& scene, const Profile& profile, Rays& rays) {
    benchmark::DoNotOptimize(segmentation_of(scene, profile, rays).node.data());
  });
}
void Boxes(benchmark::State& state) {
  std::size_t objects = 0, frames = 0;
  look_around(state, Viewer(views().scenes.front()), [&](const Scene& scene, const Profile& profile, Viewer& viewer) {
    objects += viewer.view(viewed(scene), scene.agent, profile, profile.sight_m).size();
    ++frames;
  });
  state.counters["objects"] = static_cast<double>(objects) / static_cast<double>(frames);
}
void Rgb(benchmark::State& state) {
  look_around(state, Rays(), [](const Scene& scene, const Profile& profile, Rays& rays) {
    benchmark::DoNotOptimize(picture_of(scene, profile, rays).rgb.data());
  });
}
void RgbAsPng(benchmark::State& state) {
  look_around(state, Rays(), [](const Scene& scene, const Profile& profile, Rays& rays) {
    const Picture picture = picture_of(scene, profile, rays);
    benchmark::DoNotOptimize(png(picture.width, picture.height, picture.rgb));
  });
}

BENCHMARK(Segmentation)->Unit(benchmark::kMillisecond);
BENCHMARK(Boxes)->Unit(benchmark::kMillisecond);
BENCHMARK(Rgb)->Unit(benchmark::kMillisecond);
BENCHMARK(RgbAsPng)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace unietp

BENCHMARK_MAIN();
