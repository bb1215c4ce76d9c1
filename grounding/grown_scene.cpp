#include "grounding/grown_scene.h"

#include <algorithm>

#include "grounding/current_state.h"

namespace unietp {

GrownScene read_grown(const Home& home, const Scene& scene) {
  GrownScene grown;
  grown.changed = differences(home, scene);
  grown.physics = physics_of(home, scene, grown.changed);
  std::vector<std::size_t> moved = grown.changed.nodes;
  moved.insert(moved.end(), grown.changed.gone.begin(), grown.changed.gone.end());
  grown.walk = walk_of(home, scene, std::move(moved));
  grown.places = home.places;
  CurrentState present(home);
  for (const std::size_t i : grown.changed.gone) {
    present.touch(home.scene.nodes[i].id, home.physics.bounds(BodyId::node(i)));
    grown.places.remove(i, home.scene.nodes[i]);
  }
  for (const std::size_t i : grown.changed.nodes) {
    present.touch(scene.nodes[i].id, grown.physics.bounds(BodyId::node(i)));
    grown.places.add(i, scene.nodes[i]);
  }
  for (const std::size_t i : grown.changed.states) present.touch(scene.nodes[i].id);
  present.read(scene, grown.places, grown.physics);
  grown.edges = present.since_home();
  grown.links = present.links_read();
  grown.now = present.now();
  grown.reader = present.reader();
  return grown;
}

KnownStart known_start(const Home& home, const Scene& scene, GrownScene grown) {
  const Differences& changed = grown.changed;
  KnownStart known{.physics = std::move(grown.physics)};
  known.viewer = *home.viewer;
  if (!scene.agent.held.empty() || !home.scene.agent.held.empty()) return known;
  const PhysicsWorld& physics = known.physics;
  LinkTable& links = known.links.emplace(home.links);
  auto& colliders = known.colliders.emplace(home.colliders);
  const std::size_t count = scene.nodes.size();
  links.resize(std::max(count, links.size()));
  while (colliders.size() < count) colliders.emplace_back();
  while (colliders.size() > count) colliders.pop_back();
  for (const std::size_t i : changed.nodes) colliders.edit(i) = physics.share(BodyId::node(i));
  for (const std::size_t i : changed.gone) links.set(i, {});
  for (auto& [i, read] : grown.links) links.set(i, std::move(read));
  links.resize(count);
  known.walk = std::move(grown.walk);
  known.places = std::move(grown.places);
  known.read = ReadScene{std::move(grown.reader), std::move(grown.now.states.front())};
  return known;
}

}  // namespace unietp
