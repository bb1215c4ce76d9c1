#include "grounding/current_state.h"

#include <algorithm>
#include <utility>

#include "core/sort_unique.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

std::vector<Edge> edges_of_agent(const Scene& scene) {
  const Room* room = room_at(scene, scene.agent.position);
  if (room == nullptr) return {};
  return {{Predicate::InRoom, "agent", room->id}};
}

}  // namespace

CurrentState::CurrentState(const Home& home)
    : home_(&home), reader_(home.reader), trace_(home.now), agent_(home.scene.agent) {}

void CurrentState::touch(const std::string& id, const Bounds& bounds) {
  touched_.push_back(id);
  bounds_.push_back(bounds);
}

void CurrentState::touch(const std::string& id) { restated_.push_back(id); }

std::vector<Edge> CurrentState::edges_from(std::string_view id) const {
  std::vector<Edge> edges;
  const auto entity = reader_.find(id);
  if (!entity) return edges;
  for (const auto& [relation, other] : trace_.states.front().relations(*entity))
    edges.push_back({relation, std::string(id), trace_.entities[other].id});
  std::sort(edges.begin(), edges.end());
  return edges;
}

void CurrentState::read(const Scene& scene, const NodeIndex& places, const PhysicsWorld& physics) {
  if (touched_.empty() && restated_.empty() && scene.agent == agent_) return;
  sort_unique(touched_);
  Delta change;
  std::vector<std::size_t> changed;
  for (const std::string& id : touched_) {
    if (const auto place = places.find(id)) {
      changed.push_back(*place);
    } else {
      change.removed.push_back(id);
    }
  }
  std::sort(changed.begin(), changed.end());  // what is new is numbered as it stands in the scene
  for (const std::size_t i : changed) change.nodes.push_back(scene.nodes[i]);
  sort_unique(restated_);
  for (const std::string& id : restated_) {
    const auto place = places.find(id);
    if (place && !std::binary_search(changed.begin(), changed.end(), *place))
      change.nodes.push_back(scene.nodes[*place]);
  }
  for (const std::string& id : change.removed) note({{}, edges_from(id)});
  EdgeChange edges;
  links_read_.clear();
  for (const std::size_t i : affected_by(physics, bounds_, changed)) {
    std::vector<Edge> after;
    const auto& links = links_read_.emplace_back(i, links_of(scene, physics, i)).second;
    for (const Link& link : links) after.push_back(edge_of(scene, i, link));
    sort_unique(after);
    edges.replace(edges_from(scene.nodes[i].id), after);
  }
  if (scene.agent != agent_) {
    edges.replace(edges_from("agent"), edges_of_agent(scene));
    change.agent = agent_ = scene.agent;
  }
  edges.sort();
  note(edges);
  change.edges_added = std::move(edges.added);
  change.edges_removed = std::move(edges.removed);
  Facts& facts = trace_.states.front();
  facts = reader_.read(std::move(facts), change);
  trace_.entities.follow(reader_.entities());
  ever_touched_.insert(touched_.begin(), touched_.end());
  ever_touched_.insert(restated_.begin(), restated_.end());
  touched_.clear();
  restated_.clear();
  bounds_.clear();
}

void CurrentState::note(const EdgeChange& edges) {
  for (const Edge& edge : edges.removed) {
    if (added_.erase(edge) == 0) removed_.insert(edge);
  }
  for (const Edge& edge : edges.added) {
    if (removed_.erase(edge) == 0) added_.insert(edge);
  }
}

EdgeChange CurrentState::since_home() const {
  return {{added_.begin(), added_.end()}, {removed_.begin(), removed_.end()}};
}

}  // namespace unietp
