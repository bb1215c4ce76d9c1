#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "grounding/layout.h"
#include "simulation/navigation.h"

namespace unietp {

/// What an agent sees in furnished homes: scenes of one simulator with its profile.
struct FurnishedViews {
  Profile profile;
  std::vector<Scene> scenes;
};

/// Homes of 7 rooms and 210 objects, each seen from `views` places drawn from those where the body can stand, level or
/// a little down, in pictures of `pixels` by `pixels`. Deterministic.
inline FurnishedViews furnished_views(Simulator simulator, std::size_t homes, std::size_t views, int pixels) {
  const std::filesystem::path root = UNIETP_SOURCE_DIR;
  const auto file = std::filesystem::temp_directory_path() / ("unietp_views_" + std::to_string(::getpid()) + ".sqlite");
  compile_knowledge(root / "data/akb", file);
  const auto knowledge = load_knowledge(file, simulator);
  std::filesystem::remove(file);
  const auto recipe = load_recipe(root / "data/layouts", *knowledge);
  FurnishedViews seen{*load_profile(root / "data/simulators", simulator), {}};
  seen.profile.image_width = seen.profile.image_height = pixels;
  LayoutOptions options;
  options.rooms = 7;
  options.objects = 210;
  Rng rng(3);
  for (std::uint64_t i = 0; seen.scenes.size() < homes * views; ++i) {
    auto home = generate_layout(*recipe, *knowledge, seen.profile, options, "home", rng.fork("home", i));
    if (!home) continue;
    const NavigationGrid grid(*home, seen.profile);
    for (std::size_t drawn = 0; drawn < views;) {
      const NavigationGrid::Cell cell{static_cast<int>(rng.below(static_cast<std::uint64_t>(grid.width()))),
                                      static_cast<int>(rng.below(static_cast<std::uint64_t>(grid.height())))};
      if (!grid.free(cell)) continue;
      home->agent.position = grid.center(cell);
      home->agent.yaw = 6.28 * rng.unit();
      home->agent.pitch = 0.5 * rng.unit();
      seen.scenes.push_back(*home);
      ++drawn;
    }
  }
  return seen;
}

}  // namespace unietp
