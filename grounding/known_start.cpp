#include "simulation/known_start.h"

#include <algorithm>

#include "grounding/present.h"

namespace unietp {

KnownStart known_start(const Home& home, const Scene& scene) {
  const Differences changed = differences(home, scene);
  KnownStart known{.physics = physics_of(home, scene, changed)};
  if (!scene.agent.held.empty() || !home.scene.agent.held.empty()) return known;
  const PhysicsWorld& physics = known.physics;
  LinkTable& links = known.links.emplace(home.links);
  auto& colliders = known.colliders.emplace(home.colliders);
  const std::size_t count = scene.nodes.size();
  links.resize(std::max(count, links.size()));
  while (colliders.size() < count) colliders.emplace_back();
  while (colliders.size() > count) colliders.pop_back();
  for (const std::size_t i : changed.nodes) colliders.edit(i) = physics.share(static_cast<BodyId>(i));
  for (const std::size_t i : changed.gone) links.set(i, {});
  std::vector<Bounds> touched;
  for (const std::size_t i : changed.gone) touched.push_back(home.physics.bounds(static_cast<BodyId>(i)));
  for (const std::size_t i : changed.nodes) touched.push_back(physics.bounds(static_cast<BodyId>(i)));
  for (const std::size_t i : affected_by(physics, touched, changed.nodes)) links.set(i, links_of(scene, physics, i));
  links.resize(count);
  NavigationGrid& grid = known.grid.emplace(home.walk->grid);
  for (const std::size_t i : changed.gone) {
    if (i >= scene.nodes.size()) grid.update(i, nullptr, nullptr);
  }
  for (const std::size_t i : changed.nodes)
    grid.update(i, &scene.nodes[i], &physics.collider(static_cast<BodyId>(i)).shape);
  GrownScene grown = read_grown(home, scene, changed, physics);
  known.places = std::move(grown.places);
  known.read = ReadScene{std::move(grown.reader), std::move(grown.now.states.front())};
  return known;
}

}  // namespace unietp
