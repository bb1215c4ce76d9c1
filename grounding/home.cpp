#include "grounding/home.h"

#include <algorithm>
#include <utility>

#include "core/sort_unique.h"
#include "simulation/relations.h"
#include "simulation/shape.h"

namespace unietp {
namespace {

/// As NavigationGrid takes it: what lies on furniture does not stop a body.
bool stops_a_body(const Node& node) { return !node.movable || stands_low(bounds_of(node.pose, node.size)); }

/// Whether two nodes stand in a body's way alike.
bool same_solids(const Node& a, const Node& b) {
  return a.archetype == b.archetype && a.openable == b.openable && a.size == b.size && a.pose == b.pose &&
         a.opening == b.opening && a.boards == b.boards;
}

}  // namespace

bool same_body(const Node& a, const Node& b) {
  return same_solids(a, b) && a.id == b.id && a.category == b.category && a.movable == b.movable && a.mass == b.mass &&
         a.slice_of == b.slice_of && a.whole_category == b.whole_category;
}

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

double goes_beyond(const std::optional<Bounds>& space, const Bounds& bounds) {
  if (!space) return 0;
  return std::max({0.0, (bounds.low - space->low).maxCoeff(), (space->high - bounds.high).maxCoeff()});
}

Home prepare_home(Scene scene, const Profile& profile) {
  Home home;
  home.physics = physics_of(scene);
  home.physics.prepare();
  home.links = LinkTable(scene, home.physics);
  scene.edges = home.links.edges(scene);
  PlacementChecker solids;
  set_walls(solids, scene);
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const Shape shape = shape_of(node);
    solids.set(BodyId::node(i), shape, node.pose, node.opening);
    home.bounds.push_back(bounds_of(shape, node.pose, node.opening));
    home.sweeps.push_back(node.movable ? std::nullopt : sweep_of(node));
    home.farthest_sweep = std::max(home.farthest_sweep, goes_beyond(home.sweeps.back(), home.bounds.back()));
    home.colliders.push_back(home.physics.share(BodyId::node(i)));
    home.rooms.push_back(room_number(home.physics, node.pose.position.head<2>()));
  }
  home.solids = PlacementChecker::shared(std::move(solids));
  Walk walk = walk_in(scene, profile);
  DistanceField steps(walk.grid, walk.grid.cell_at(scene.agent.position));
  steps.finish();
  walk.steps = std::make_shared<const DistanceField>(std::move(steps));
  home.walk = std::make_shared<const Walk>(std::move(walk));
  home.cut_off = unreached_rooms(scene, *home.walk);
  home.now.states.push_back(home.reader.read(scene));
  home.reader.share();
  home.now.entities = home.reader.entities();
  home.places = NodeIndex(scene.nodes);
  home.viewer = std::make_shared<const Viewer>(scene);
  home.scene = std::move(scene);
  return home;
}

bool is_of_use(const Home& home, std::size_t node, bool inside) {
  return home.out_of_reach.empty() || !(home.out_of_reach[node] || (inside && home.stuck[node]));
}

std::optional<std::string> newly_unreached(const Home& home, const Scene& scene,
                                           const std::shared_ptr<const Walk>& walk) {
  if (walk == home.walk) return std::nullopt;
  for (const std::string& id : unreached_rooms(scene, *walk)) {
    if (std::find(home.cut_off.begin(), home.cut_off.end(), id) == home.cut_off.end()) return id;
  }
  return std::nullopt;
}

Differences differences(const Home& home, const Scene& scene) {
  Differences found;
  const auto& before = home.scene.nodes;
  const auto& after = scene.nodes;
  const std::size_t end = std::max(before.size(), after.size());
  for (std::size_t i = 0; (i = before.first_of_its_own(after, i)) < end; ++i) {
    if (i < before.size() && i < after.size() && same_body(before[i], after[i])) {
      if (before[i] != after[i]) found.states.push_back(i);
      continue;
    }
    if (i < after.size()) found.nodes.push_back(i);
    if (i < before.size()) found.gone.push_back(i);
  }
  return found;
}

PhysicsWorld physics_of(const Home& home, const Scene& scene, const Differences& changed) {
  PhysicsWorld physics = home.physics;
  for (const std::size_t i : changed.gone) {
    if (i >= scene.nodes.size()) physics.remove(BodyId::node(i));
  }
  for (const std::size_t i : changed.nodes) {
    const Node& node = scene.nodes[i];
    physics.set(BodyId::node(i), shape_of(node), node.pose, node.opening, node.movable ? node.mass : 0);
  }
  return physics;
}

std::optional<NavigationGrid> other_grid(const Home& home, const Scene& scene, std::vector<std::size_t> places) {
  const auto& before = home.scene.nodes;
  const auto& after = scene.nodes;
  sort_unique(places);
  std::erase_if(places, [&](std::size_t i) {
    if (i < before.size() && i < after.size() && same_solids(before[i], after[i])) return true;
    return !(i < before.size() && stops_a_body(before[i])) && !(i < after.size() && stops_a_body(after[i]));
  });
  if (places.empty()) return std::nullopt;
  NavigationGrid grid = home.walk->grid;
  for (const std::size_t i : places) {
    if (i < after.size()) {
      const Shape shape = shape_of(after[i]);
      grid.update(i, &after[i], &shape);
    } else {
      grid.update(i, nullptr, nullptr);
    }
  }
  return grid;
}

std::shared_ptr<const Walk> walk_of(const Home& home, const Scene& scene, std::vector<std::size_t> places) {
  auto grid = other_grid(home, scene, std::move(places));
  if (!grid && scene.agent.position == home.scene.agent.position) return home.walk;
  auto walk = std::make_shared<Walk>(Walk{grid ? *grid : home.walk->grid, {}, {}});
  const auto from = walk->grid.cell_at(scene.agent.position);
  walk->reached = walk->grid.reached_from(from, home.walk->grid, home.walk->reached);
  return walk;
}

Scene without_edges(const Scene& scene) {
  return {scene.id, scene.simulator, scene.rooms, scene.openings, scene.wall_height, scene.wall_thickness, scene.nodes,
          {},       scene.agent};
}

std::int32_t room_number(const PhysicsWorld& world, const Vec2& point) {
  const auto room = world.floor().at(point);
  return room ? static_cast<std::int32_t>(*room) : -1;
}

}  // namespace unietp
