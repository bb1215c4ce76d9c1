#include "grounding/small_objects.h"

#include <algorithm>
#include <map>

#include "grounding/make_node.h"
#include "grounding/place_object.h"

namespace unietp {
namespace {

constexpr double kSizeSpread = 0.04;
constexpr double kUsualRoomFactor = 4;
constexpr double kCrowding = 0.5;  // how much each thing already there makes a receptacle less likely
constexpr int kTriesPerObject = 4;
constexpr int kReceptaclesPerTry = 3;

bool in_usual_room(const Workspace& workspace, const Category& category, const Node& host) {
  const Room* room = room_at(workspace.scene(), host.pose.position.head<2>());
  return room != nullptr && std::find(category.rooms.begin(), category.rooms.end(), room->type) != category.rooms.end();
}

}  // namespace

std::vector<Host> hosts_for(const Workspace& workspace, const Node& object) {
  const Knowledge& knowledge = workspace.knowledge();
  const Category* category = knowledge.find(object.category);
  std::vector<Host> hosts;
  if (category == nullptr) return hosts;
  std::map<std::string_view, int> instances;
  for (const Node& node : workspace.scene().nodes) ++instances[node.category];
  for (std::size_t i = 0; i < workspace.scene().nodes.size(); ++i) {
    const Node& host = workspace.scene().nodes[i];
    if (host.id == object.id) continue;
    for (const Predicate relation : {Predicate::On, Predicate::Inside}) {
      const Placement* placement =
          knowledge.placement(object.category, relation == Predicate::On ? "on" : "inside", host.category);
      if (placement == nullptr || placement->likelihood <= 0) continue;
      double weight = placement->likelihood / instances[host.category];
      if (in_usual_room(workspace, *category, host)) weight *= kUsualRoomFactor;
      hosts.push_back({i, relation, weight});
    }
  }
  return hosts;
}

int scatter_objects(Workspace& workspace, int wanted, int draws_per_object, Rng rng) {
  const Knowledge& knowledge = workspace.knowledge();
  std::vector<const Category*> categories;
  for (const Category& category : knowledge.categories()) {
    if (!category.movable) continue;
    const bool placeable = !knowledge.placements_of(category.name, "on").empty() ||
                           !knowledge.placements_of(category.name, "inside").empty();
    if (placeable) categories.push_back(&category);
  }
  if (categories.empty()) return 0;
  std::vector<double> weights(categories.size(), 1.0);
  std::map<std::size_t, int> carried;  // things put on or in a node so far
  int placed = 0;
  for (int attempt = 0; attempt < wanted * kTriesPerObject && placed < wanted; ++attempt) {
    Rng draw = rng.fork("object", static_cast<std::uint64_t>(attempt));
    const std::size_t chosen = draw.weighted(weights);
    Node node = make_node(workspace.scene(), knowledge, *categories[chosen], kSizeSpread, draw);
    draw_states(node, knowledge, draw);
    std::vector<Host> hosts = hosts_for(workspace, node);
    if (hosts.empty()) {
      weights[chosen] = 0;
      if (*std::max_element(weights.begin(), weights.end()) <= 0) break;
      continue;
    }
    bool done = false;
    for (int choice = 0; choice < kReceptaclesPerTry && !done && !hosts.empty(); ++choice) {
      std::vector<double> chances;
      for (const Host& host : hosts) chances.push_back(host.weight / (1 + kCrowding * carried[host.node]));
      const std::size_t at = draw.weighted(chances);
      const Host host = hosts[at];
      hosts.erase(hosts.begin() + static_cast<std::ptrdiff_t>(at));
      const FoundPlace place = find_place(workspace, node, workspace.scene().nodes.size(), host.relation, host.node,
                                          {.draws = std::max(1, draws_per_object / kReceptaclesPerTry)},
                                          draw.fork("place", static_cast<std::uint64_t>(choice)));
      if (!place.pose) continue;
      node.pose = *place.pose;
      workspace.add(node);
      ++carried[host.node];
      done = true;
    }
    if (done) {
      ++placed;
      weights[chosen] /= 3;
    } else {
      weights[chosen] /= 2;
    }
  }
  return placed;
}

}  // namespace unietp
