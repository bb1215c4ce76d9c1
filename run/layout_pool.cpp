#include "run/layout_pool.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "core/sort_unique.h"
#include "grounding/given_home.h"
#include "run/make_home.h"
#include "scene/comparisons.h"
#include "scene/trace.h"

namespace unietp {
namespace {

/// Whether a home that was given, and may lack much, can give a task something of the category: furniture that can be
/// used, or a thing that it has or that people keep on or in such furniture.
bool can_offer(const Home& home, const std::string& name, const Backend& backend, const Household& household) {
  const Category* category = backend.knowledge.find(name);
  if (category == nullptr) return true;  // a type of room
  const auto is_usable = [&](std::size_t node, bool inside) {
    return home.scene.nodes[node].movable || is_of_use(home, node, inside);
  };
  const auto& there = home.places.of(name);
  if (!there.empty())
    return std::any_of(there.begin(), there.end(),
                       [&](std::size_t node) { return is_usable(node, home.scene.nodes[node].openable); });
  const auto& usual = household.places_of(name);
  return usual.empty() || std::any_of(usual.begin(), usual.end(), [&](const Household::Place& place) {
           const auto& hosts = home.places.of(place.receptacle);
           return std::any_of(hosts.begin(), hosts.end(),
                              [&](std::size_t host) { return is_usable(host, place.relation == Predicate::Inside); });
         });
}

Layout layout_of(Scene scene, const Backend& backend, const PlaceUses* uses, const Household* of_given) {
  Layout layout;
  layout.home = of_given == nullptr ? prepare_home(std::move(scene), backend.profile)
                                    : prepare_given_home(std::move(scene), backend.profile);
  const Home& home = layout.home;
  layout.offer = {offered_categories(home.scene, backend.knowledge), home.now, uses};
  if (of_given != nullptr)
    std::erase_if(layout.offer.categories,
                  [&](const std::string& name) { return !can_offer(home, name, backend, *of_given); });
  Facts& now = layout.offer.now.states.front();
  now = with_comparisons(now, home.scene, home.reader, {.all = true, .categories = {}});
  return layout;
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
      const bool is_given = entry.given != nullptr && !resources_.recipes.empty();
      return layout_of(std::move(*home), resources_.backend(simulator),
                       resources_.sense == nullptr ? nullptr : &resources_.sense->common.place_uses(),
                       is_given ? resources_.recipe(simulator).household.get() : nullptr);
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
    for (const Predicate relation : {Predicate::On, Predicate::Inside}) {
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
