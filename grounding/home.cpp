#include "grounding/home.h"

#include <algorithm>
#include <utility>

#include "simulation/relations.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

/// As NavigationGrid takes it: what lies on furniture does not stop a body.
bool stops_a_body(const Node& node) { return !node.movable || stands_low(bounds_of(node.pose, node.size)); }

/// Whether two nodes stand in a body's way alike: colours and states do not.
bool same_solids(const Node& a, const Node& b) {
  return a.archetype == b.archetype && a.openable == b.openable && a.size == b.size && a.pose == b.pose &&
         a.opening == b.opening && a.boards == b.boards;
}

}  // namespace

std::optional<Bounds> sweep_of(const Node& node) {
  if (!node.openable) return std::nullopt;
  const Shape shape = shape_of(node);
  std::optional<Bounds> swept;
  for (const Part& part : shape.parts) {
    if (part.joint < 0) continue;
    for (int k = 0; k <= 4; ++k) {
      const Bounds one = bounds_of(node.pose * joint_motion(shape, part.joint, k / 4.0) * part.pose, part.size);
      if (!swept) swept = one;
      swept->low = swept->low.cwiseMin(one.low);
      swept->high = swept->high.cwiseMax(one.high);
    }
  }
  return swept;
}

Home prepare_home(Scene scene, const Profile& profile) {
  Home home;
  home.physics = physics_of(scene);
  scene.edges = read_relations(scene, home.physics);
  PlacementChecker solids;
  set_walls(solids, scene);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const Shape shape = shape_of(node);
    solids.set(static_cast<BodyId>(i), shape, node.pose, node.opening);
    home.bounds.push_back(bounds_of(shape, node.pose, node.opening));
    home.sweeps.push_back(node.movable ? std::nullopt : sweep_of(node));
  }
  home.solids = PlacementChecker::shared(std::move(solids));
  home.walk = std::make_shared<const Walk>(walk_in(scene, profile));
  home.unreached = unreached_room(scene, *home.walk);
  home.now = to_logic(scene, {}, true);
  home.scene = std::move(scene);
  return home;
}

Differences differences(const Home& home, const Scene& scene) {
  Differences found;
  const auto& before = home.scene.nodes;
  const auto& after = scene.nodes;
  for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
    if (i < before.size() && i < after.size() && before[i] == after[i]) continue;
    if (i < after.size()) found.nodes.push_back(i);
    if (i < before.size()) found.gone.push_back(i);
  }
  return found;
}

PhysicsWorld physics_of(const Home& home, const Scene& scene) {
  PhysicsWorld physics = home.physics;
  const Differences changed = differences(home, scene);
  for (const std::size_t i : changed.gone) {
    if (i >= scene.nodes.size()) physics.remove(static_cast<BodyId>(i));
  }
  for (const std::size_t i : changed.nodes) {
    const Node& node = scene.nodes[i];
    physics.set(static_cast<BodyId>(i), shape_of(node), node.pose, node.opening, node.movable ? node.mass : 0);
  }
  return physics;
}

std::vector<Edge> relations_of(const Home& home, const Scene& scene, const PhysicsWorld& physics) {
  const Differences changed = differences(home, scene);
  std::vector<Bounds> touched;
  for (const std::size_t i : changed.gone) touched.push_back(home.bounds[i]);
  for (const std::size_t i : changed.nodes) touched.push_back(physics.bounds(static_cast<BodyId>(i)));
  std::vector<std::string> lost;  // ids that the scene no longer has
  for (const std::size_t i : changed.gone) {
    const std::string& id = home.scene.nodes[i].id;
    const bool stays =
        std::any_of(changed.nodes.begin(), changed.nodes.end(), [&](std::size_t k) { return scene.nodes[k].id == id; });
    if (!stays) lost.push_back(id);
  }
  std::vector<Edge> before = home.scene.edges;
  if (!lost.empty()) {
    const auto is_lost = [&](const std::string& id) { return std::find(lost.begin(), lost.end(), id) != lost.end(); };
    std::erase_if(before, [&](const Edge& edge) { return is_lost(edge.from) || is_lost(edge.to); });
  }
  return update_relations(scene, before, physics, {}, touched, changed.nodes);
}

std::shared_ptr<const Walk> walk_of(const Home& home, const Scene& scene, const Profile& profile) {
  const auto& before = home.scene.nodes;
  const auto& after = scene.nodes;
  bool same = scene.agent.position == home.scene.agent.position;
  for (std::size_t i = 0; same && i < std::max(before.size(), after.size()); ++i) {
    if (i < before.size() && i < after.size() && same_solids(before[i], after[i])) continue;
    same = !(i < before.size() && stops_a_body(before[i])) && !(i < after.size() && stops_a_body(after[i]));
  }
  return same ? home.walk : std::make_shared<const Walk>(walk_in(scene, profile));
}

Trace state_of(const Home& home, const Scene& scene, bool with_comparisons) {
  return difference(home.scene, scene).empty() ? home.now : to_logic(scene, {}, with_comparisons);
}

}  // namespace unietp
