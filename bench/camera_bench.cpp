// What it costs to look, in furnished homes of 7 rooms and 210 objects, on one core. `Segmentation`, one ray through
// every pixel, is the baseline of `Boxes`; compare with it, not with the clock. `Everything` is a picture of 300 x 300
// pixels with all that pictures show, over 1,000 views in 20 homes.
#include <benchmark/benchmark.h>

#include "bench/furnished_views.h"
#include "core/png.h"
#include "simulation/channels.h"
#include "simulation/picture.h"
#include "simulation/solids.h"
#include "simulation/view.h"

namespace unietp {
namespace {

const FurnishedViews& views() {
  static const FurnishedViews kViewsOfHome = furnished_views(Simulator::Ai2thor, 1, 16, 500);
  return kViewsOfHome;
}

template <class Workplace, class Look>
void look_around(benchmark::State& state, Workplace workplace, Look look) {
  const FurnishedViews& all = views();
  std::size_t i = 0;
  for (auto _ : state) look(all.scenes[i++ % all.scenes.size()], all.profile, workplace);
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

/// The mean over all views is that of one iteration, which looks at each of them once.
void Everything(benchmark::State& state) {
  static const std::vector<FurnishedViews> kOfSimulators = [] {
    std::vector<FurnishedViews> all;
    for (const Simulator simulator : kSimulators) all.push_back(furnished_views(simulator, 5, 50, 300));
    return all;
  }();
  Rays rays;
  std::size_t frames = 0;
  for (auto _ : state) {
    for (const FurnishedViews& seen : kOfSimulators) {
      for (const Scene& scene : seen.scenes) {
        benchmark::DoNotOptimize(picture_of(scene, seen.profile, rays).rgb.data());
        ++frames;
      }
    }
  }
  state.counters["frames/s"] = benchmark::Counter(static_cast<double>(frames), benchmark::Counter::kIsRate);
}

BENCHMARK(Segmentation)->Unit(benchmark::kMillisecond);
BENCHMARK(Boxes)->Unit(benchmark::kMillisecond);
BENCHMARK(Rgb)->Unit(benchmark::kMillisecond);
BENCHMARK(RgbAsPng)->Unit(benchmark::kMillisecond);
BENCHMARK(Everything)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace unietp

BENCHMARK_MAIN();
