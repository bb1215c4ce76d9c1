#include "simulation/world_state.h"

#include <algorithm>
#include <cmath>

#include "simulation/agent_moves.h"
#include "simulation/relations.h"

namespace unietp {
namespace {

constexpr double kHandHeight_m = 1.0;

}  // namespace

const NavigationGrid& WorldState::grid() const {
  if (!grid_) grid_.emplace(scene, *profile);
  return *grid_;
}

const std::vector<std::int32_t>& WorldState::walk() const {
  if (walk_.empty()) {
    auto from = grid().cell_at(scene.agent.position);
    if (!grid().free(from)) from = grid().nearest_free(scene.agent.position).value_or(from);
    walk_ = grid().distances(from);
  }
  return walk_;
}

void WorldState::forget_grid() {
  grid_.reset();
  walk_.clear();
}

void WorldState::forget_walk() { walk_.clear(); }

std::optional<std::size_t> WorldState::index_of(std::string_view id) const {
  const Node* found = find_node(scene, id);
  if (found == nullptr) return std::nullopt;
  return static_cast<std::size_t>(found - scene.nodes.data());
}

bool WorldState::held(std::string_view id) const {
  const auto& held = scene.agent.held;
  return std::find(held.begin(), held.end(), id) != held.end();
}

std::optional<std::size_t> WorldState::closed_around(std::size_t i) const {
  std::optional<std::size_t> outermost;
  for (const Edge& edge : scene.edges) {
    if (edge.relation != Predicate::Inside || edge.from != node(i).id) continue;
    const auto container = index_of(edge.to);
    if (!container || !node(*container).openable || node(*container).states.has(Predicate::Open)) continue;
    if (!outermost || node(*container).size.prod() > node(*outermost).size.prod()) outermost = container;
  }
  return outermost;
}

std::vector<std::size_t> WorldState::group_of(std::size_t i) const {
  std::vector<std::size_t> group{i};
  for (const std::string& id : carried_by(scene, node(i).id)) {
    if (const auto index = index_of(id)) group.push_back(*index);
  }
  return group;
}

void WorldState::refresh(std::span<const Bounds> touched, std::span<const std::size_t> changed) {
  std::vector<std::string> in_hand;
  for (const std::string& id : scene.agent.held) {
    in_hand.push_back(id);
    const auto carried = carried_by(scene, id);
    in_hand.insert(in_hand.end(), carried.begin(), carried.end());
  }
  const auto is_in_hand = [&](const std::string& id) {
    return std::find(in_hand.begin(), in_hand.end(), id) != in_hand.end();
  };
  std::vector<Edge> carried;
  for (const Edge& edge : scene.edges) {
    const bool contact = edge.relation == Predicate::On || edge.relation == Predicate::Inside;
    if (contact && is_in_hand(edge.from) && is_in_hand(edge.to)) carried.push_back(edge);
  }
  const std::vector<Edge> before = scene.edges;
  scene.edges = update_relations(scene, physics, carried, touched, changed);
  keep_attached(before);
}

void WorldState::keep_attached(std::span<const Edge> before) {
  std::erase_if(scene.edges, [](const Edge& edge) { return edge.relation == Predicate::Attached; });
  for (const Edge& edge : before) {
    if (edge.relation != Predicate::Attached || !has_edge(scene, Predicate::On, edge.from, edge.to)) continue;
    scene.edges.insert(std::lower_bound(scene.edges.begin(), scene.edges.end(), edge), edge);
  }
}

void WorldState::carry_along() {
  const Vec2 ahead(std::cos(scene.agent.yaw), std::sin(scene.agent.yaw));
  const Vec2 left(-ahead.y(), ahead.x());
  const Vec2 at = scene.agent.position + hand.ahead_m * ahead + hand.left_m * left;
  std::vector<std::size_t> moved;
  for (const std::string& id : scene.agent.held) {
    const auto i = index_of(id);
    if (!i) continue;
    const Pose grip = upright(Vec3(at.x(), at.y(), kHandHeight_m), scene.agent.yaw + hand.turn);
    const Pose motion = grip * inverse(node(*i).pose);
    for (const std::size_t member : group_of(*i)) {
      node(member).pose = member == *i ? grip : motion * node(member).pose;
      moved.push_back(member);
    }
  }
  refresh({}, moved);
}

std::optional<Outcome> out_of_hands_way(const WorldState& state, std::size_t node) {
  const std::string& id = state.node(node).id;
  if (const auto container = state.closed_around(node)) {
    return failed(Failure::InsideClosed, id + " is inside " + state.node(*container).id + ", which is closed.");
  }
  if (reach_distance(state.node(node), state.scene.agent.position, *state.profile) > state.profile->reach_m) {
    return failed(Failure::TooFar, id + " is out of reach; go to it first.");
  }
  if (!sees(state.scene, state.physics, *state.profile, state.scene.agent.position, node)) {
    return failed(Failure::NotVisible, id + " is not in sight from here.");
  }
  return std::nullopt;
}

void look_at(WorldState& state, const Vec3& point) {
  state.scene.agent = facing(std::move(state.scene.agent), point, *state.profile);
}

}  // namespace unietp
