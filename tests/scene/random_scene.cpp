#include "random_scene.h"
#include "scene/fresh_id.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace unietp {
namespace {

constexpr std::array kCategories{"Mug", "Fridge", "TVStand", "wine glass", "kéttle/~"};
constexpr std::array kObjectRelations{Predicate::On,    Predicate::Inside,  Predicate::NextTo,
                                      Predicate::Under, Predicate::SliceOf, Predicate::Attached};

double awkward(Rng& rng) {
  const double scale = std::pow(10.0, rng.uniform(-12, 1.5));
  return rng.chance(0.1) ? 0.0 : rng.uniform(-1, 1) * scale;
}
double awkward_positive(Rng& rng) { return std::abs(awkward(rng)) + 1e-9; }

StateSet random_states(Rng& rng) {
  StateSet states;
  for (const StateGroup& group : state_groups()) {
    if (!rng.chance(0.4)) continue;
    const Predicate predicate = rng.pick(group.predicates);
    states.set({predicate, predicate == Predicate::Filled ? "water (hot)" : ""});
  }
  if (rng.chance(0.2)) states.set({Predicate::Covered, "dust"});
  if (rng.chance(0.2)) states.set({Predicate::Covered, "a \"stain\" \\"});
  return states;
}

void add_random_edges(Scene& scene, Rng& rng) {
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    const std::string& from = rng.pick(scene.nodes).id;
    if (rng.chance(0.5)) {
      scene.edges.insert({kObjectRelations[rng.below(kObjectRelations.size())], from, rng.pick(scene.nodes).id});
    } else {
      const auto relation = rng.chance(0.5) ? Predicate::OnFloor : Predicate::InRoom;
      scene.edges.insert({relation, from, rng.pick(scene.rooms).id});
    }
  }
  scene.edges.insert({Predicate::InRoom, "agent", rng.pick(scene.rooms).id});
}

void make_sound(Scene& scene) {
  const auto gone = [&](const std::string& id) {
    return id != "agent" && !find_node(scene, id) && !find_room(scene, id);
  };
  erase_if(scene.edges, [&](const Edge& edge) { return gone(edge.from) || gone(edge.to); });
  std::erase_if(scene.agent.held, gone);
}

Agent random_agent(const Scene& scene, Rng& rng) {
  Agent agent{{awkward(rng), awkward(rng)}, rng.uniform(-4, 4), rng.uniform(-2, 2), {}};
  if (!scene.nodes.empty() && rng.chance(0.5)) agent.held.push_back(rng.pick(scene.nodes).id);
  return agent;
}

}  // namespace

Node random_node(std::string id, Rng& rng) {
  Node node;
  node.id = std::move(id);
  node.category = kCategories[rng.below(kCategories.size())];
  node.movable = rng.chance(0.5);
  node.archetype = all_archetypes()[rng.below(all_archetypes().size())];
  node.openable = rng.chance(0.5);
  node.size = {awkward_positive(rng), awkward_positive(rng), awkward_positive(rng)};
  node.mass = awkward_positive(rng);
  node.pose.position = {awkward(rng), awkward(rng), awkward(rng)};
  node.pose.rotation =
      Quat(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1), rng.uniform(-1, 1)).normalized();
  node.opening = rng.chance(0.5) ? 0.0 : rng.unit();
  while (rng.chance(0.3)) {
    node.boards.push_back({{awkward(rng), awkward(rng), awkward(rng)},
                           {awkward_positive(rng), awkward_positive(rng), awkward_positive(rng)},
                           static_cast<int>(rng.below(3)) - 1});
  }
  node.states = random_states(rng);
  if (rng.chance(0.3)) node.color = "red";
  if (rng.chance(0.3)) node.material = "oak~/wood";
  if (rng.chance(0.2)) node.asset = "Bread_4";
  if (rng.chance(0.2)) node.slice_of = "bread_1", node.whole_category = "Bread";
  return node;
}

Scene random_scene(Rng& rng) {
  Scene scene;
  scene.id = "scene_" + std::to_string(rng.below(100));
  scene.simulator = kSimulators[rng.below(kSimulators.size())];
  scene.wall_height = rng.uniform(2, 3);
  if (rng.chance(0.5)) scene.wall_thickness = rng.uniform(0.01, 0.3);
  const auto rooms = static_cast<int>(1 + rng.below(3));
  for (int i = 0; i < rooms; ++i) {
    const double x = 4.0 * i;
    scene.rooms.push_back({"room_" + std::to_string(i), "kitchen", {{x, 0}, {x + 4, 0}, {x + 4, 3.1}, {x, 3.1}}});
    if (i == 0) continue;
    scene.openings.push_back({"opening_" + std::to_string(i),
                              scene.rooms[static_cast<std::size_t>(i - 1)].id,
                              scene.rooms.back().id,
                              {x, 1},
                              {x, 1.9},
                              awkward_positive(rng)});
  }
  const std::uint64_t nodes = rng.below(41);
  for (std::uint64_t i = 0; i < nodes; ++i) scene.nodes.push_back(random_node("thing_" + std::to_string(i), rng));
  scene.agent = random_agent(scene, rng);
  add_random_edges(scene, rng);
  make_sound(scene);
  return scene;
}

Scene random_successor(Scene scene, Rng& rng) {
  erase_if(scene.nodes, [&](const Node&) { return rng.chance(0.1); });
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    Node& node = scene.nodes.edit(i);
    if (rng.chance(0.2)) node = random_node(node.id, rng);
    if (rng.chance(0.2)) node.states.set({Predicate::Hot, ""});
  }
  const std::uint64_t added = rng.below(4);
  for (std::uint64_t i = 0; i < added; ++i) scene.nodes.push_back(random_node(fresh_id(scene, "Slice"), rng));
  erase_if(scene.edges, [&](const Edge&) { return rng.chance(0.3); });
  if (rng.chance(0.5)) add_random_edges(scene, rng);
  if (rng.chance(0.5)) scene.agent = random_agent(scene, rng);
  make_sound(scene);
  return scene;
}

}  // namespace unietp
