#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace unietp {

/// The edges of one relation that start at a thing, of a sorted list.
std::span<const Edge> edges_from(const std::vector<Edge>& edges, Predicate relation, std::string_view from);
/// Of all relations, sorted.
std::vector<Edge> edges_from(const std::vector<Edge>& edges, std::string_view from);

/// How one sorted list of edges differs from another.
struct EdgeChange {
  std::vector<Edge> added, removed;

  /// The edges from one thing were `before` and are `after`, both sorted.
  void replace(const std::vector<Edge>& before, const std::vector<Edge>& after);
  /// After the last `replace`: both lists sorted.
  void sort();
  /// The list that becomes of one which has what is removed and lacks what is added.
  std::vector<Edge> applied_to(const std::vector<Edge>& edges) const;
  /// Whether that is `after`, without making it.
  bool leads(const std::vector<Edge>& edges, const std::vector<Edge>& after) const;
};

}  // namespace unietp
