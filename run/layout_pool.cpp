#include "run/layout_pool.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "core/sort_unique.h"
#include "scene/comparisons.h"
#include "scene/trace.h"

namespace unietp {
namespace {

constexpr std::uint64_t kTriesPerLayout = 8;

std::string layout_id(Simulator simulator, int index) {
  auto digits = std::to_string(index + 1);
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  return std::string(name_of(simulator)) + "-home-" + digits;
}

Layout layout_of(Scene scene, const Backend& backend) {
  Layout layout;
  layout.home = prepare_home(std::move(scene), backend.profile);
  const Home& home = layout.home;
  layout.offer = {offered_categories(home.scene, backend.knowledge), home.now};
  Facts& now = layout.offer.now.states.front();
  now = with_comparisons(now, home.scene, home.reader, {.all = true, .categories = {}});
  return layout;
}

Result<Scene> draw_home(const RunConfiguration& configuration, const Resources& resources, Simulator simulator,
                        int number) {
  const auto& backend = resources.backend(simulator);
  LayoutOptions options;
  options.rooms = configuration.rooms;
  options.movable_objects = configuration.objects;
  const Rng stream = Rng(configuration.seed).fork("layout", static_cast<std::uint64_t>(simulator));
  Error last;
  for (std::uint64_t attempt = 0; attempt < kTriesPerLayout; ++attempt) {
    auto scene = generate_layout(resources.recipe(simulator), backend.knowledge, backend.profile, options,
                                 layout_id(simulator, number),
                                 stream.fork("home", static_cast<std::uint64_t>(number) * kTriesPerLayout + attempt));
    if (scene) return scene;
    last = scene.error();
  }
  return last;
}

Result<Scene> benchmark_home(const Resources& resources, Simulator simulator, int number) {
  int passed = 0;
  for (const BenchmarkLayout& layout : resources.benchmark) {
    if (layout.simulator != simulator || passed++ != number) continue;
    const auto& backend = resources.backend(simulator);
    return benchmark_layout(layout, resources.recipe(simulator), backend.knowledge, backend.profile);
  }
  return Error{Error::Kind::Usage,
               "benchmark.csv",
               {},
               "has no home number " + std::to_string(number + 1) + " of " + std::string(name_of(simulator))};
}

Result<Scene> make_home(const RunConfiguration& configuration, const Resources& resources, Simulator simulator,
                        int number) {
  const auto& backend = resources.backend(simulator);
  switch (configuration.homes) {
    case HomeSource::Drawn:
      return draw_home(configuration, resources, simulator, number);
    case HomeSource::Benchmark:
      return benchmark_home(resources, simulator, number);
    case HomeSource::Training:
      return training_layout(resources.recipe(simulator), backend.knowledge, backend.profile,
                             static_cast<std::uint64_t>(number), configuration.seed);
  }
  return draw_home(configuration, resources, simulator, number);
}

BlockHomes first_homes(const Resources& resources, int homes) {
  BlockHomes ranges{};
  for (auto& range : ranges) range.count = homes;
  if (resources.homes.empty()) return ranges;
  ranges = {};
  for (const Scene& home : resources.homes) ++ranges[static_cast<std::size_t>(home.simulator)].count;
  return ranges;
}

}  // namespace

LayoutPool::LayoutPool(const RunConfiguration& configuration, const Resources& resources, int homes)
    : LayoutPool(configuration, resources, first_homes(resources, homes)) {}

LayoutPool::LayoutPool(const RunConfiguration& configuration, const Resources& resources, const BlockHomes& homes)
    : configuration_(configuration), resources_(resources) {
  for (const Simulator simulator : kSimulators) {
    const auto s = static_cast<std::size_t>(simulator);
    std::vector<const Scene*> given;
    for (const Scene& home : resources.homes) {
      if (home.simulator == simulator) given.push_back(&home);
    }
    for (int number = homes[s].first; number < homes[s].first + homes[s].count; ++number) {
      entries_[s].push_back(std::make_unique<Entry>());
      entries_[s].back()->number = number;
      if (!given.empty()) entries_[s].back()->given = given[static_cast<std::size_t>(number)];
    }
  }
}

const Result<Layout>& LayoutPool::layout(Simulator simulator, int index) {
  Entry& entry = *of(simulator)[static_cast<std::size_t>(index)];
  std::call_once(entry.once, [&] {
    const auto made = [&]() -> Result<Layout> {
      auto home = entry.given != nullptr ? Result<Scene>(*entry.given)
                                         : make_home(configuration_, resources_, simulator, entry.number);
      if (!home) return home.error();
      return layout_of(std::move(*home), resources_.backend(simulator));
    };
    entry.layout = std::make_unique<Result<Layout>>(made());
  });
  return *entry.layout;
}

std::vector<std::string> offered_categories(const Scene& scene, const Knowledge& knowledge) {
  std::vector<std::string_view> offered;
  for (const Node& node : scene.nodes) offered.push_back(node.category);
  sort_unique(offered);
  const std::vector<std::string_view> present = offered;
  std::unordered_set<std::string_view> known(present.begin(),
                                             present.end());  // many places offer the same; never iterated
  for (const std::string_view receptacle : present) {
    for (const char* relation : {"on", "inside"}) {
      for (const Placement* placement : knowledge.placements_at(receptacle, relation)) {
        if (known.insert(placement->object).second) offered.push_back(placement->object);
      }
    }
  }
  sort_unique(offered);
  std::erase_if(offered, [&](std::string_view name) {
    const Category* category = knowledge.find(name);
    return !std::binary_search(present.begin(), present.end(), name) && (category == nullptr || !category->movable);
  });
  for (const Room& room : scene.rooms) offered.push_back(room.type);
  sort_unique(offered);
  return {offered.begin(), offered.end()};
}

}  // namespace unietp
