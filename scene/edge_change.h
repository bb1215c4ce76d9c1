#pragma once

#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace unietp {

/// Neighbors in an EdgeSet; valid until the set changes. Not a std::ranges::subrange, which clang 14 cannot compile
/// with the headers of g++ 12.
class EdgeRange {
 public:
  /// The edges from `first` on, before `end`, in the order of the set.
  EdgeRange(EdgeSet::const_iterator first, EdgeSet::const_iterator end) : first_(first), end_(end) {}
  EdgeSet::const_iterator begin() const { return first_; }
  EdgeSet::const_iterator end() const { return end_; }

 private:
  EdgeSet::const_iterator first_, end_;
};

/// The edges of one relation that start at a thing.
EdgeRange edges_from(const EdgeSet& edges, Predicate relation, std::string_view from);
/// Of all relations, sorted.
std::vector<Edge> edges_from(const EdgeSet& edges, std::string_view from);

/// How one set of edges differs from another.
struct EdgeChange {
  std::vector<Edge> added, removed;

  /// Notes that the edges that start at one object were `before` and are now `after`; both sorted.
  void replace(const std::vector<Edge>& before, const std::vector<Edge>& after);
  /// Sorts both lists. Call it once, after the last `replace`.
  void sort();
  /// The given edges after this change. Takes time in proportion to the change.
  EdgeSet applied_to(EdgeSet edges) const;
};

}  // namespace unietp
