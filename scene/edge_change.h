#pragma once

#include <ranges>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace unietp {

using EdgeRange = std::ranges::subrange<EdgeSet::const_iterator>;

/// The edges of one relation that start at a thing.
EdgeRange edges_from(const EdgeSet& edges, Predicate relation, std::string_view from);
/// Of all relations, sorted.
std::vector<Edge> edges_from(const EdgeSet& edges, std::string_view from);

/// How one set of edges differs from another.
struct EdgeChange {
  std::vector<Edge> added, removed;

  /// The edges from one thing were `before` and are `after`, both sorted.
  void replace(const std::vector<Edge>& before, const std::vector<Edge>& after);
  /// After the last `replace`: both lists sorted.
  void sort();
  /// The edges that become of the given ones, at the cost of the change.
  EdgeSet applied_to(EdgeSet edges) const;
};

}  // namespace unietp
