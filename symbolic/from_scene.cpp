#include "symbolic/from_scene.h"

#include <algorithm>
#include <set>

#include "scene/trace.h"

namespace unietp::symbolic {
namespace {

std::vector<std::string> categories_of(const std::vector<const Node*>& nodes) {
  std::set<std::string> names;
  for (const auto* node : nodes) names.insert(node->category);
  return {names.begin(), names.end()};
}

/// Number of containers around a thing. Of two containers of one thing, the one with more around it is the inner one.
std::ptrdiff_t depth_of(const Scene& scene, const std::string& id) {
  return std::count_if(scene.edges.begin(), scene.edges.end(),
                       [&](const Edge& edge) { return edge.relation == Predicate::Inside && edge.from == id; });
}

const Edge* resting_edge(const Scene& scene, const std::string& id) {
  const Edge* nearest = nullptr;
  std::ptrdiff_t deepest = -1;
  for (const auto& edge : scene.edges) {
    if (edge.from != id || find_node(scene, edge.to) == nullptr) continue;
    if (edge.relation == Predicate::On) return &edge;
    if (edge.relation != Predicate::Inside) continue;
    if (const auto depth = depth_of(scene, edge.to); depth > deepest) {
      deepest = depth;
      nearest = &edge;
    }
  }
  return nearest;
}

bool is_held(const Scene& scene, const std::string& id) {
  const auto& held = scene.agent.held;
  return std::find(held.begin(), held.end(), id) != held.end();
}

}  // namespace

const Node* support_of(const Scene& scene, const Node& node) {
  const auto* edge = is_held(scene, node.id) ? nullptr : resting_edge(scene, node.id);
  return edge == nullptr ? nullptr : find_node(scene, edge->to);
}

SceneSymbols::SceneSymbols(const Scene& scene, const Knowledge& knowledge, ActionProfile profile,
                           const std::vector<const Node*>& nodes)
    : rules(knowledge, capabilities_of(scene.simulator, profile), categories_of(nodes)) {
  setting.rules = &rules;
  setting.with_nearest = false;
  for (const auto& room : scene.rooms) setting.objects.rooms.push_back({room.id, room.type});
  for (const auto* node : nodes) {
    ObjectEntry role;
    role.id = node->id;
    role.kind = rules.kind_named(node->category).value();
    role.color = node->color;
    role.material = node->material;
    setting.objects.things.push_back(std::move(role));
    Thing thing;
    for (const auto& state : node->states.all()) {
      if (state.predicate == Predicate::Covered) {
        thing.coats.insert(rules.symbol_number(state.symbol));
        continue;
      }
      thing.set(state.predicate);
      if (state.predicate == Predicate::Filled) thing.filling = rules.symbol_number(state.symbol);
    }
    start.things.push_back(thing);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    auto& thing = start.things[i];
    const auto& id = nodes[i]->id;
    if (is_held(scene, id)) {
      thing.where = PlaceKind::Hand;
      start.held = Id::thing(i);
    } else if (const auto* edge = resting_edge(scene, id); edge != nullptr) {
      thing.where = edge->relation == Predicate::On ? PlaceKind::On : PlaceKind::Inside;
      thing.at = setting.objects.named(edge->to);
    } else {
      for (const auto& edges : scene.edges) {
        if (edges.relation == Predicate::InRoom && edges.from == id) thing.at = setting.objects.named(edges.to);
      }
    }
  }
  if (const auto* room = room_at(scene, scene.agent.position); room != nullptr)
    start.room = setting.objects.named(room->id);
  FactReader reader(true);
  seen.states.push_back(reader.read(scene));
  seen.entities = reader.entities();
  for (const auto& entity : seen.entities)
    objects.push_back(entity.kind == Entity::Kind::Agent ? kAgent : setting.objects.named(entity.id));
  add_pieces(setting, start);
}

}  // namespace unietp::symbolic
