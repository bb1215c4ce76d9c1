#include "scene/edge_change.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/sort_unique.h"

namespace unietp {
namespace {

using Place = std::vector<Edge>::const_iterator;

/// The list after a change, in order: runs of edges that stay, and between them those that come.
template <class Stay, class Come>
void follow(const EdgeChange& change, const std::vector<Edge>& edges, const Stay& stay, const Come& come) {
  Place at = edges.begin();
  auto added = change.added.begin(), removed = change.removed.begin();
  while (added != change.added.end() || removed != change.removed.end()) {
    const bool adds = removed == change.removed.end() || (added != change.added.end() && *added < *removed);
    const Place next = std::lower_bound(at, edges.end(), adds ? *added : *removed);
    stay(at, next);
    at = next;
    if (adds) {
      come(*added++);
    } else {
      if (at != edges.end() && *at == *removed) ++at;
      ++removed;
    }
  }
  stay(at, edges.end());
}

}  // namespace

std::span<const Edge> edges_from(const std::vector<Edge>& edges, Predicate relation, std::string_view from) {
  using Key = std::pair<Predicate, std::string_view>;
  const auto key_of = [](const Edge& edge) { return Key(edge.relation, edge.from); };
  const Key wanted(relation, from);
  const auto first =
      std::partition_point(edges.begin(), edges.end(), [&](const Edge& edge) { return key_of(edge) < wanted; });
  const auto last = std::find_if(first, edges.end(), [&](const Edge& edge) { return key_of(edge) != wanted; });
  return {first, last};
}

std::vector<Edge> edges_from(const std::vector<Edge>& edges, std::string_view from) {
  std::vector<Edge> found;
  for (auto run = edges.begin(); run != edges.end();) {
    const Predicate relation = run->relation;
    const auto here = edges_from(edges, relation, from);
    found.insert(found.end(), here.begin(), here.end());
    run = std::partition_point(run, edges.end(), [&](const Edge& one) { return one.relation == relation; });
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

std::vector<Edge> EdgeChange::applied_to(const std::vector<Edge>& edges) const {
  std::vector<Edge> after;
  after.reserve(edges.size() + added.size());
  follow(
      *this, edges, [&](Place from, Place to) { after.insert(after.end(), from, to); },
      [&](const Edge& edge) { after.push_back(edge); });
  return after;
}

bool EdgeChange::leads(const std::vector<Edge>& edges, const std::vector<Edge>& after) const {
  bool same = true;
  Place at = after.begin();
  follow(
      *this, edges,
      [&](Place from, Place to) {
        same = same && to - from <= after.end() - at && std::equal(from, to, at);
        if (same) at += to - from;
      },
      [&](const Edge& edge) {
        same = same && at != after.end() && *at == edge;
        if (same) ++at;
      });
  return same && at == after.end();
}

}  // namespace unietp
