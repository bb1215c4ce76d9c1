#include "pipeline/layout_pool.h"

#include <set>

#include "pipeline/slots.h"

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
  layout.offer = {offered_categories(layout.home.scene, backend.knowledge), layout.home.now};
  return layout;
}

Result<Layout> make_layout(const RunConfiguration& configuration, const Resources& resources, Simulator simulator,
                           int index) {
  const auto& backend = resources.backend(simulator);
  LayoutOptions options;
  options.rooms = configuration.rooms;
  options.movable_objects = configuration.objects;
  const Rng stream = Rng(configuration.seed).fork("layout", static_cast<std::uint64_t>(simulator));
  Error last;
  for (std::uint64_t attempt = 0; attempt < kTriesPerLayout; ++attempt) {
    auto scene = generate_layout(resources.recipe(simulator), backend.knowledge, backend.profile, options,
                                 layout_id(simulator, index),
                                 stream.fork("home", static_cast<std::uint64_t>(index) * kTriesPerLayout + attempt));
    if (scene) return layout_of(std::move(*scene), backend);
    last = scene.error();
  }
  return last;
}

}  // namespace

LayoutPool::LayoutPool(const RunConfiguration& configuration, const Resources& resources)
    : LayoutPool(configuration, resources, layouts_per_simulator(configuration)) {}

LayoutPool::LayoutPool(const RunConfiguration& configuration, const Resources& resources, int homes)
    : configuration_(configuration), resources_(resources) {
  for (const Scene& home : resources.homes) {
    auto& own = entries_[static_cast<std::size_t>(home.simulator)];
    own.push_back(std::make_unique<Entry>());
    own.back()->given = &home;
  }
  if (!resources.homes.empty()) return;
  for (auto& own : entries_) {
    for (int i = 0; i < homes; ++i) own.push_back(std::make_unique<Entry>());
  }
}

const Result<Layout>& LayoutPool::layout(Simulator simulator, int index) {
  Entry& entry = *of(simulator)[static_cast<std::size_t>(index)];
  std::call_once(entry.once, [&] {
    const auto made = [&]() -> Result<Layout> {
      if (entry.given == nullptr) return make_layout(configuration_, resources_, simulator, index);
      return layout_of(*entry.given, resources_.backend(simulator));
    };
    entry.layout = std::make_unique<Result<Layout>>(made());
  });
  return *entry.layout;
}

std::vector<std::string> offered_categories(const Scene& scene, const Knowledge& knowledge) {
  std::set<std::string> offered;
  for (const auto& node : scene.nodes) offered.insert(node.category);
  const std::set<std::string> present = offered;
  for (const auto& placement : knowledge.placements()) {
    if (placement.relation != "on" && placement.relation != "inside") continue;
    const Category* object = knowledge.find(placement.object);
    if (object != nullptr && object->movable && present.count(placement.receptacle) > 0)
      offered.insert(placement.object);
  }
  for (const auto& room : scene.rooms) offered.insert(room.type);
  return {offered.begin(), offered.end()};
}

}  // namespace unietp
