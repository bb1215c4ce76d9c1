#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/shared_list.h"
#include "scene/scene.h"
#include "simulation/physics.h"
#include "simulation/relations.h"

namespace unietp {

/// The links of the nodes of a scene, and the other way round which nodes each one carries. Copies share what has not
/// changed since.
class LinkTable {
 public:
  LinkTable() = default;
  /// As physics shows them.
  LinkTable(const Scene& scene, const PhysicsWorld& physics);

  std::size_t size() const { return links_.size(); }
  /// Sorted.
  const std::vector<Link>& of(std::size_t node) const { return links_[node]; }
  /// What lies on or in a node, directly. Sorted.
  const std::vector<std::uint32_t>& carried(std::size_t node) const { return carried_[node]; }

  /// All of them as edges, and in_room of the agent; sorted.
  std::vector<Edge> edges(const Scene& scene) const;

  /// Nodes at the end, without links and carrying nothing, until there are so many; or fewer of such nodes.
  void resize(std::size_t nodes);
  /// Gives the node other links, sorted ones, and takes the present ones away in `links`.
  void exchange(std::size_t node, std::vector<Link>& links);
  void set(std::size_t node, std::vector<Link> links) { exchange(node, links); }

 private:
  SharedList<std::vector<Link>> links_;
  SharedList<std::vector<std::uint32_t>> carried_;
};

}  // namespace unietp
