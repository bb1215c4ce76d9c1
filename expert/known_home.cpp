#include "expert/known_home.h"

#include <algorithm>
#include <utility>

#include "grounding/reachability.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

/// The places of what the agent holds, with what lies on or in that.
std::vector<std::size_t> in_the_hand(const Scene& scene) {
  std::vector<std::string> ids;
  for (const std::string& id : scene.agent.held) {
    ids.push_back(id);
    for (std::string& carried : carried_by(scene, id)) ids.push_back(std::move(carried));
  }
  // What is fixed is carried by nothing, even where a hand is held under it.
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < scene.nodes.size() && !ids.empty(); ++i) {
    if (scene.nodes[i].movable && std::find(ids.begin(), ids.end(), scene.nodes[i].id) != ids.end())
      places.push_back(i);
  }
  return places;
}

}  // namespace

KnownHome::KnownHome(const Scene& known_scene, const Profile& profile)
    : physics_(physics_of(known_scene, colliders_)),
      walk_(std::make_shared<const Walk>(walk_in(known_scene, profile))),
      viewer_(known_scene),
      last_{known_scene.nodes, physics_, walk_->grid, LinkTable(known_scene, physics_)} {}

KnownStart KnownHome::start() const { return {.physics = physics_, .walk = walk_, .viewer = viewer_}; }

/// Takes over what differs from what was believed last.
void KnownHome::believe(const Scene& scene) {
  std::vector<std::size_t> changed;
  std::vector<Bounds> touched;  // before and after
  const auto touch = [&](std::size_t i) {
    if (last_.physics.has(BodyId::node(i))) touched.push_back(last_.physics.bounds(BodyId::node(i)));
  };
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    if (i < last_.nodes.size() && node == last_.nodes[i]) continue;
    const auto collider = colliders_.of(node);
    touch(i);
    last_.physics.set(BodyId::node(i), collider, node.pose, node.movable ? node.mass : 0);
    last_.grid.update(i, &node, &collider->shape);
    touch(i);
    changed.push_back(i);
  }
  for (std::size_t i = scene.nodes.size(); i < last_.nodes.size(); ++i) {
    touch(i);
    last_.physics.remove(BodyId::node(i));
    last_.grid.update(i, nullptr, nullptr);
    last_.links.set(i, {});
  }
  last_.links.resize(std::max(scene.nodes.size(), last_.nodes.size()));
  for (const std::size_t i : affected_by(last_.physics, touched, changed))
    last_.links.set(i, links_of(scene, last_.physics, i));
  last_.links.resize(scene.nodes.size());
  last_.nodes = scene.nodes;
}

KnownStart KnownHome::of(Scene& scene) {
  believe(scene);
  scene.edges = last_.links.edges(scene);
  KnownStart known{.physics = last_.physics, .links = last_.links, .viewer = viewer_};
  NavigationGrid grid = last_.grid;
  if (const auto in_hand = in_the_hand(scene); !in_hand.empty()) {
    for (const std::size_t i : in_hand) grid.update(i, nullptr, nullptr);
    known.links = std::nullopt;  // which are of a home where nothing is in the hand
  }
  CellSet reached = grid.reached_from(grid.cell_at(scene.agent.position), walk_->grid, walk_->reached);
  known.walk = std::make_shared<const Walk>(Walk{std::move(grid), std::move(reached), {}});
  return known;
}

}  // namespace unietp
