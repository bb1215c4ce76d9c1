#include "scene/edge_change.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/sort_unique.h"

namespace unietp {

EdgeRange edges_from(const EdgeSet& edges, Predicate relation, std::string_view from) {
  using Key = std::pair<Predicate, std::string_view>;
  const Key wanted(relation, from);
  const auto key_of = [](const Edge& edge) { return Key(edge.relation, edge.from); };
  const auto first = edges.partition_point([&](const Edge& edge) { return key_of(edge) < wanted; });
  return {first, std::find_if(first, edges.end(), [&](const Edge& edge) { return key_of(edge) != wanted; })};
}

std::vector<Edge> edges_from(const EdgeSet& edges, std::string_view from) {
  std::vector<Edge> found;
  for (auto run = edges.begin(); run != edges.end();) {
    const Predicate relation = run->relation;
    const auto here = edges_from(edges, relation, from);
    found.insert(found.end(), here.begin(), here.end());
    run = edges.partition_point([&](const Edge& one) { return one.relation <= relation; });
  }
  return found;
}

void EdgeChange::replace(const std::vector<Edge>& before, const std::vector<Edge>& after) {
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(added));
  std::set_difference(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(removed));
}

void EdgeChange::sort() {
  sort_unique(added);
  sort_unique(removed);
}

EdgeSet EdgeChange::applied_to(EdgeSet edges) const {
  for (const Edge& edge : removed) edges.erase(edge);
  for (const Edge& edge : added) edges.insert(edge);
  return edges;
}

}  // namespace unietp
