#include "homes/home_plans.h"

#include <algorithm>

#include "core/text.h"

namespace unietp {
namespace {

Result<Scene> draw_home(const LayoutRecipe& recipe, const Backend& backend, const LayoutOptions& options,
                        const std::string& id, const Rng& stream) {
  constexpr std::uint64_t kTries = 8;
  Error last;
  for (std::uint64_t attempt = 0; attempt < kTries; ++attempt) {
    auto scene =
        generate_layout(recipe, backend.knowledge, backend.profile, options, id, stream.fork("attempt", attempt));
    if (scene) return scene;
    last = scene.error();
  }
  return last;
}

}  // namespace

HomeInputsReading load_home_inputs(const DataFolders& folders) {
  auto backends = load_backends(folders);
  HomeInputsReading reading{{std::move(backends.backends), {}}, std::move(backends.errors)};
  if (!reading.errors.empty()) return reading;
  for (const auto& backend : reading.inputs.backends) {
    auto recipe = load_recipe(folders.layouts(), backend.knowledge);
    if (recipe) {
      reading.inputs.recipes.push_back(std::move(*recipe));
    } else {
      reading.errors.push_back(recipe.error());
    }
  }
  return reading;
}

std::vector<HomePlan> new_homes(const HomeInputs& inputs, Simulator simulator, const NewHomeOptions& wanted) {
  const auto& backend = inputs.backends[static_cast<std::size_t>(simulator)];
  const auto& recipe = inputs.recipes[static_cast<std::size_t>(simulator)];
  const bool sized = wanted.rooms > 0 || wanted.objects > 0;
  LayoutOptions size;
  if (wanted.rooms > 0) size.rooms = wanted.rooms;
  size.objects = wanted.objects > 0 ? wanted.objects : 30 * size.rooms;
  const auto seed = wanted.seed;
  const Rng pool = Rng(seed).fork("sized-layout", static_cast<std::uint64_t>(simulator));

  std::vector<HomePlan> homes;
  for (std::uint64_t n = 0; n < static_cast<std::uint64_t>(wanted.count); ++n) {
    const std::string id = std::string(name_of(simulator)) + (sized ? "-sized-" : "-training-") + std::to_string(seed) +
                           "-" + std::to_string(n);
    if (sized) {
      homes.push_back(
          {id, [&, size, id, stream = pool.fork("home", n)] { return draw_home(recipe, backend, size, id, stream); }});
    } else {
      homes.push_back(
          {id, [&, n, seed] { return training_layout(recipe, backend.knowledge, backend.profile, n, seed); }});
    }
  }
  return homes;
}

Result<std::vector<HomePlan>> benchmark_homes(const HomeInputs& inputs, const DataFolders& folders, bool all,
                                              const std::vector<std::string>& ids) {
  const auto layouts = benchmark_layouts(folders.layouts());
  if (!layouts) return layouts.error();
  std::vector<std::string> known;
  for (const auto& layout : *layouts) known.push_back(layout.id);
  for (const auto& id : ids) {
    if (std::find(known.begin(), known.end(), id) != known.end()) continue;
    const auto near = nearest_name(id, known);
    return Error{Error::Kind::Usage,
                 "--layout",
                 {},
                 "the benchmark has no home \"" + id + "\"" + (near.empty() ? "" : ", did you mean \"" + near + "\"") +
                     "; `unietp scene list` shows all"};
  }
  std::vector<HomePlan> homes;
  for (const auto& layout : *layouts) {
    if (!all && std::find(ids.begin(), ids.end(), layout.id) == ids.end()) continue;
    const auto& backend = inputs.backends[static_cast<std::size_t>(layout.simulator)];
    const auto& recipe = inputs.recipes[static_cast<std::size_t>(layout.simulator)];
    homes.push_back(
        {layout.id, [&, layout] { return benchmark_layout(layout, recipe, backend.knowledge, backend.profile); }});
  }
  return homes;
}

}  // namespace unietp
