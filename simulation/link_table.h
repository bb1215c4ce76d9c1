#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/shared_list.h"
#include "scene/scene.h"
#include "simulation/physics.h"
#include "simulation/relations.h"

namespace unietp {

/// The links of the nodes of a scene, and the inverse: which nodes each one carries. Copies share unchanged parts.
class LinkTable {
 public:
  LinkTable() = default;
  /// Read from physics.
  LinkTable(const Scene& scene, const PhysicsWorld& physics);

  std::size_t size() const { return links_.size(); }
  /// Sorted.
  const std::vector<Link>& of(std::size_t node) const { return links_[node]; }
  /// What lies on or in a node, directly. Sorted.
  const std::vector<std::uint32_t>& carried(std::size_t node) const { return carried_[node]; }

  /// All links as edges, with in_room of the agent; sorted.
  std::vector<Edge> edges(const Scene& scene) const;

  /// Adds or removes nodes at the end, which have no links and carry nothing.
  void resize(std::size_t nodes);
  /// Swaps the node's links with `links`, which must be sorted.
  void exchange(std::size_t node, std::vector<Link>& links);
  void set(std::size_t node, std::vector<Link> links) { exchange(node, links); }

 private:
  SharedList<std::vector<Link>> links_;
  SharedList<std::vector<std::uint32_t>> carried_;
};

}  // namespace unietp
