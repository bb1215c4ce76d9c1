#include "validator/rest.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <unordered_map>

#include "simulation/digest.h"

namespace unietp {
namespace {

constexpr double kTogether_m = 0.02;  // loose things nearer than this are let go together

/// Two seconds, or a tenth of a second in which nothing moves, half a second where something lies near an edge.
SettleOptions watched() {
  SettleOptions options;
  options.max_steps = static_cast<int>(std::lround(2.0 / options.step_s));
  options.calm_steps = options.max_steps / 20;
  options.edge_calm_steps = options.max_steps / 4;
  return options;
}

bool is_loose(const Scene& scene, const Node& node) {
  const auto& held = scene.agent.held;
  return node.movable && std::find(held.begin(), held.end(), node.id) == held.end();
}

/// Loose nodes in groups of those that touch one another, each in order, the groups by their first.
std::vector<std::vector<BodyId>> groups_of(const Scene& scene, const PhysicsWorld& physics) {
  const auto count = scene.nodes.size();
  std::vector<bool> waiting(count, false);
  for (std::size_t i = 0; i < count; ++i) waiting[i] = is_loose(scene, scene.nodes[i]) && physics.has(BodyId::node(i));
  std::vector<std::vector<BodyId>> groups;
  for (std::size_t i = 0; i < count; ++i) {
    if (!waiting[i]) continue;
    std::vector<BodyId> group{BodyId::node(i)};
    waiting[i] = false;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (const BodyId other : physics.near(physics.bounds(group[next]), kTogether_m)) {
        if (!other.is_node() || !waiting[other.index()]) continue;
        waiting[other.index()] = false;
        group.push_back(other);
      }
    }
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

void add(Digester& digest, const Vec3& v) { digest.add(v.x()).add(v.y()).add(v.z()); }

/// All of a body that physics is given.
void add_body(Digester& digest, const Scene& scene, const PhysicsWorld& physics, BodyId id) {
  if (!id.is_node()) {  // floor and walls: upright boxes
    const Bounds bounds = physics.bounds(id);
    add(digest, bounds.low);
    return add(digest, bounds.high);
  }
  const Node& node = scene.nodes[id.index()];
  digest.add(static_cast<std::uint64_t>(node.archetype) * 2 + (node.openable ? 1 : 0)).add(node.mass).add(node.opening);
  add(digest, node.size);
  add(digest, node.pose.position);
  const Quat& turn = node.pose.rotation;
  digest.add(turn.w()).add(turn.x()).add(turn.y()).add(turn.z()).add(std::uint64_t{node.boards.size()});
  for (const Board& board : node.boards) {
    add(digest, board.center);
    add(digest, board.size);
    const int joint = board.joint + 1;  // 0: moves with the body
    digest.add(static_cast<std::uint64_t>(joint));
  }
}

Digest key_of(const Scene& scene, const PhysicsWorld& physics, const std::vector<BodyId>& group, double reach_m) {
  Digester digest;
  Bounds region = physics.bounds(group.front());
  digest.add(std::uint64_t{group.size()});
  for (const BodyId id : group) {
    add_body(digest, scene, physics, id);
    region = {region.low.cwiseMin(physics.bounds(id).low), region.high.cwiseMax(physics.bounds(id).high)};
  }
  region.low.z() = -1;  // whatever lies below can be fallen on
  for (const BodyId id : physics.near(region, reach_m)) {
    if (!std::binary_search(group.begin(), group.end(), id)) add_body(digest, scene, physics, id);
  }
  return digest.digest();
}

}  // namespace

struct RestCheck::Memory {
  std::mutex mutex;
  std::unordered_map<Digest, std::vector<Moved>, DigestHash> known;  // node: place in the group
};

RestCheck::RestCheck(double moved_m) : moved_m_(moved_m), memory_(std::make_unique<Memory>()) {}
RestCheck::~RestCheck() = default;

std::vector<RestCheck::Moved> RestCheck::of(const Scene& scene, const PhysicsWorld& physics) {
  std::vector<Moved> all;
  const SettleOptions options = watched();
  for (const auto& group : groups_of(scene, physics)) {
    const Digest key = key_of(scene, physics, group, options.surroundings_m);
    std::unique_lock lock(memory_->mutex);
    auto known = memory_->known.find(key);
    if (known == memory_->known.end()) {
      lock.unlock();
      std::vector<Moved> moved;
      const auto settled = physics.settle(group, options);
      for (std::size_t i = 0; i < group.size(); ++i) {
        const double distance = (settled.bodies[i].pose.position - scene.nodes[group[i].index()].pose.position).norm();
        if (!(distance <= moved_m_)) moved.push_back({i, distance});  // also when it is no number
      }
      lock.lock();
      known = memory_->known.emplace(key, std::move(moved)).first;
    }
    for (const Moved& one : known->second) all.push_back({group[one.node].index(), one.distance_m});
  }
  std::sort(all.begin(), all.end(), [](const Moved& a, const Moved& b) { return a.node < b.node; });
  return all;
}

}  // namespace unietp
