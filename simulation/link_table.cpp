#include "simulation/link_table.h"

#include <algorithm>
#include <utility>

#include "core/sort_unique.h"

namespace unietp {
namespace {

std::vector<std::uint32_t> carriers_in(const std::vector<Link>& links) {
  std::vector<std::uint32_t> carriers;
  for (const Link& link : links) {
    if (carries(link)) carriers.push_back(link.to);
  }
  sort_unique(carriers);
  return carriers;
}

}  // namespace

LinkTable::LinkTable(const Scene& scene, const PhysicsWorld& physics) {
  resize(scene.nodes.size());
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) set(i, links_of(scene, physics, i));
}

std::vector<Edge> LinkTable::edges(const Scene& scene) const {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    for (const Link& link : links_[i]) edges.push_back(edge_of(scene, i, link));
  }
  if (const Room* room = room_at(scene, scene.agent.position)) edges.push_back({Predicate::InRoom, "agent", room->id});
  sort_unique(edges);
  return edges;
}

void LinkTable::resize(std::size_t nodes) {
  while (links_.size() < nodes) links_.emplace_back(), carried_.emplace_back();
  while (links_.size() > nodes) links_.pop_back(), carried_.pop_back();
}

void LinkTable::exchange(std::size_t node, std::vector<Link>& links) {
  const auto rider = static_cast<std::uint32_t>(node);
  const auto before = carriers_in(links_[node]), after = carriers_in(links);
  for (const std::uint32_t carrier : before) {
    if (!std::binary_search(after.begin(), after.end(), carrier)) std::erase(carried_.edit(carrier), rider);
  }
  for (const std::uint32_t carrier : after) {
    if (std::binary_search(before.begin(), before.end(), carrier)) continue;
    auto& riders = carried_.edit(carrier);
    riders.insert(std::lower_bound(riders.begin(), riders.end(), rider), rider);
  }
  std::swap(links_.edit(node), links);
}

}  // namespace unietp
