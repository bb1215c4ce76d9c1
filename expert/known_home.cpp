#include "expert/known_home.h"

#include <algorithm>
#include <utility>

#include "grounding/reachability.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

/// Visits the nodes of a scene that another, shorter or longer, does not have at the same place.
template <class Visit>
void each_other_node(const Scene& scene, const Scene& than, const Visit& visit) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (i >= than.nodes.size() || scene.nodes[i] != than.nodes[i]) visit(i, scene.nodes[i]);
  }
}

/// The places of what the agent holds, with what lies on or in that.
std::vector<std::size_t> in_the_hand(const Scene& scene) {
  std::vector<std::string> ids;
  for (const std::string& id : scene.agent.held) {
    ids.push_back(id);
    for (std::string& carried : carried_by(scene, id)) ids.push_back(std::move(carried));
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < scene.nodes.size() && !ids.empty(); ++i) {
    if (std::find(ids.begin(), ids.end(), scene.nodes[i].id) != ids.end()) places.push_back(i);
  }
  return places;
}

}  // namespace

KnownHome::KnownHome(const Scene& known_scene, const Profile& profile)
    : known_scene_(known_scene),
      physics_(physics_of(known_scene, colliders_)),
      walk_(std::make_shared<const Walk>(walk_in(known_scene, profile))),
      viewer_(known_scene) {}

KnownStart KnownHome::start() const { return {.physics = physics_, .walk = walk_, .viewer = viewer_}; }

KnownStart KnownHome::of(Scene& scene) {
  KnownStart known = start();
  NavigationGrid grid = walk_->grid;
  each_other_node(scene, known_scene_, [&](std::size_t i, const Node& node) {
    const auto collider = colliders_.of(node);
    known.physics.set(BodyId::node(i), collider, node.pose, node.movable ? node.mass : 0);
    grid.update(i, &node, &collider->shape);
  });
  for (std::size_t i = scene.nodes.size(); i < known_scene_.nodes.size(); ++i) {
    known.physics.remove(BodyId::node(i));
    grid.update(i, nullptr, nullptr);
  }
  known.links = LinkTable(scene, known.physics);
  scene.edges = known.links->edges(scene);
  if (const auto in_hand = in_the_hand(scene); !in_hand.empty()) {
    for (const std::size_t i : in_hand) grid.update(i, nullptr, nullptr);
    known.links = std::nullopt;  // which are of a home where nothing is in the hand
  }
  CellSet reached = grid.reached_from(grid.cell_at(scene.agent.position), walk_->grid, walk_->reached);
  known.walk = std::make_shared<const Walk>(Walk{std::move(grid), std::move(reached), {}});
  return known;
}

}  // namespace unietp
