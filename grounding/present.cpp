#include "grounding/present.h"

#include <algorithm>
#include <iterator>

#include "core/sort_unique.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

/// The edges that start at `from`, of a sorted list.
std::vector<Edge> edges_from(const std::vector<Edge>& edges, const std::string& from) {
  const auto less = [](const Edge& edge, const std::pair<Predicate, std::string_view>& wanted) {
    return std::pair(edge.relation, std::string_view(edge.from)) < wanted;
  };
  std::vector<Edge> found;
  for (auto run = edges.begin(); run != edges.end();) {
    const Predicate relation = run->relation;
    auto edge = std::lower_bound(run, edges.end(), std::pair(relation, std::string_view(from)), less);
    for (; edge != edges.end() && edge->relation == relation && edge->from == from; ++edge) found.push_back(*edge);
    run = std::partition_point(edge, edges.end(), [&](const Edge& one) { return one.relation == relation; });
  }
  return found;
}

/// What a reading changes in the edges, each part sorted in the end.
struct EdgeChange {
  std::vector<Edge> added, removed;

  /// The edges from one thing were `before` and are `after`, both sorted.
  void replace(const std::vector<Edge>& before, const std::vector<Edge>& after) {
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(added));
    std::set_difference(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(removed));
  }

  void apply_to(std::vector<Edge>& edges) const {
    if (!removed.empty()) {
      std::vector<Edge> kept;
      kept.reserve(edges.size() + added.size());
      std::set_difference(std::make_move_iterator(edges.begin()), std::make_move_iterator(edges.end()), removed.begin(),
                          removed.end(), std::back_inserter(kept));
      edges = std::move(kept);
    }
    const auto middle = static_cast<std::ptrdiff_t>(edges.size());
    edges.insert(edges.end(), added.begin(), added.end());
    std::inplace_merge(edges.begin(), edges.begin() + middle, edges.end());
  }
};

std::vector<Edge> edges_of_agent(const Scene& scene) {
  const Room* room = room_at(scene, scene.agent.position);
  if (room == nullptr) return {};
  return {{Predicate::InRoom, "agent", room->id}};
}

}  // namespace

Present::Present(const Home& home) : reader_(home.reader), trace_(home.now), agent_(home.scene.agent) {}

void Present::touch(const std::string& id, const Bounds& bounds) {
  touched_.push_back(id);
  bounds_.push_back(bounds);
}

void Present::read(const Scene& scene, const PhysicsWorld& physics, std::vector<Edge>& edges) {
  if (touched_.empty() && scene.agent == agent_) return;
  sort_unique(touched_);
  Delta change;
  std::vector<std::size_t> changed;
  for (const std::string& id : touched_) {
    if (const Node* node = find_node(scene, id)) {
      changed.push_back(static_cast<std::size_t>(node - scene.nodes.data()));
      change.nodes.push_back(*node);
    } else {
      change.removed.push_back(id);
    }
  }
  EdgeChange edge_change;
  for (const std::size_t i : affected_by(physics, bounds_, changed)) {
    std::vector<Edge> after;
    for (const Link& link : links_of(scene, physics, i)) after.push_back(edge_of(scene, i, link));
    sort_unique(after);
    edge_change.replace(edges_from(edges, scene.nodes[i].id), after);
  }
  if (!change.removed.empty()) {
    const auto is_gone = [&](const std::string& id) {
      return std::binary_search(change.removed.begin(), change.removed.end(), id);
    };
    for (const Edge& edge : edges) {
      if (is_gone(edge.from) || is_gone(edge.to)) edge_change.removed.push_back(edge);
    }
  }
  if (scene.agent != agent_) {
    edge_change.replace(edges_from(edges, "agent"), edges_of_agent(scene));
    change.agent = agent_ = scene.agent;
  }
  sort_unique(edge_change.added);
  sort_unique(edge_change.removed);
  edge_change.apply_to(edges);
  change.edges_added = std::move(edge_change.added);
  change.edges_removed = std::move(edge_change.removed);
  Facts& facts = trace_.states.front();
  facts = reader_.read(facts, change);
  const auto& known = reader_.entities();
  for (std::size_t e = trace_.entities.size(); e < known.size(); ++e) trace_.entities.push_back(known[e]);
  touched_.clear();
  bounds_.clear();
}

GrownScene read_grown(const Home& home, const Scene& scene, const PhysicsWorld& physics) {
  Present present(home);
  const Differences changed = differences(home, scene);
  for (const std::size_t i : changed.gone) {
    present.touch(home.scene.nodes[i].id, home.physics.bounds(static_cast<BodyId>(i)));
  }
  for (const std::size_t i : changed.nodes) {
    present.touch(scene.nodes[i].id, physics.bounds(static_cast<BodyId>(i)));
  }
  GrownScene grown{home.scene.edges, {}};
  present.read(scene, physics, grown.edges);
  grown.now = present.now();
  return grown;
}

}  // namespace unietp
