#include "scene/comparisons.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <unordered_map>

namespace unietp {
namespace {

using Scope = std::vector<std::pair<std::string_view, const Domain*>>;

void collect(const Formula& formula, Scope& scope, Compared& compared) {
  if (formula.op == Formula::Op::Atom &&
      (formula.predicate == Predicate::Size || formula.predicate == Predicate::Nearest)) {
    for (const Term& term : formula.terms) {
      if (term.kind != Term::Kind::Variable) continue;
      const auto bound =
          std::find_if(scope.rbegin(), scope.rend(), [&](const auto& one) { return one.first == term.name; });
      if (bound == scope.rend() || bound->second->kind == Domain::Kind::Object) {
        compared.all = true;
      } else {
        for (const auto& member : bound->second->members) compared.categories.push_back(member.category);
      }
    }
  }
  const bool binds = !formula.variable.empty();
  if (binds) scope.emplace_back(formula.variable, &formula.domain);
  for (const Formula& where : formula.domain.where) collect(where, scope, compared);
  for (const Formula& child : formula.children) collect(child, scope, compared);
  if (binds) scope.pop_back();
}

/// Where the things stand that are compared, with all others of their categories.
std::vector<std::size_t> places_of(const SharedList<Node>& nodes, const Compared& compared) {
  std::vector<std::size_t> places;
  const auto named = [&](const std::string& category) {
    return std::binary_search(compared.categories.begin(), compared.categories.end(), category);
  };
  std::set<std::string_view> categories;
  for (const Node& node : nodes) {
    if (compared.all || named(node.category) || (!node.whole_category.empty() && named(node.whole_category)))
      categories.insert(node.category);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (categories.contains(nodes[i].category)) places.push_back(i);
  }
  return places;
}

}  // namespace

void Compared::add(const Formula& formula) {
  Scope scope;
  collect(formula, scope, *this);
  std::sort(categories.begin(), categories.end());
  categories.erase(std::unique(categories.begin(), categories.end()), categories.end());
}

std::vector<NearestPair> nearest_pairs(const SharedList<Node>& nodes, const std::vector<std::size_t>& places) {
  std::unordered_map<std::string_view, std::size_t> slot_of_category;
  std::vector<std::size_t> slot;
  std::vector<Vec3> at;
  slot.reserve(places.size());
  at.reserve(places.size());
  for (const std::size_t place : places) {
    slot.push_back(slot_of_category.emplace(nodes[place].category, slot_of_category.size()).first->second);
    at.push_back(nodes[place].pose.position);
  }
  struct Best {
    double distance = 0, next = 0;  // squared
    std::size_t thing = 0;
    int found = 0;
  };
  std::vector<Best> best(slot_of_category.size());
  std::vector<NearestPair> found;
  // Of each winner's next pair; at first, how many the winner before it has.
  std::vector<std::size_t> next_of(places.size() + 1, 0);
  for (std::size_t y = 0; y < places.size(); ++y) {
    std::fill(best.begin(), best.end(), Best{});
    for (std::size_t x = 0; x < places.size(); ++x) {
      if (x == y) continue;
      const double distance = (at[x] - at[y]).squaredNorm();
      Best& so_far = best[slot[x]];
      if (so_far.found == 0 || distance < so_far.distance) {
        so_far = {distance, so_far.distance, x, so_far.found + 1};
      } else if (++so_far.found == 2 || distance < so_far.next) {
        so_far.next = distance;
      }
    }
    for (const Best& winner : best) {
      const bool wins =
          winner.found == 1 || (winner.found > 1 && clearly_nearer(std::sqrt(winner.distance), std::sqrt(winner.next)));
      if (!wins) continue;
      found.push_back({winner.thing, y});
      ++next_of[winner.thing + 1];
    }
  }
  std::partial_sum(next_of.begin(), next_of.end(), next_of.begin());
  std::vector<NearestPair> pairs(found.size());
  for (const NearestPair& pair : found) pairs[next_of[pair.winner]++] = {places[pair.winner], places[pair.other]};
  return pairs;
}

std::vector<std::pair<std::size_t, std::string>> sizes_of(const SharedList<Node>& nodes,
                                                          const std::vector<std::size_t>& places) {
  std::map<std::string_view, std::vector<std::size_t>> alike;
  for (const std::size_t i : places) alike[nodes[i].category].push_back(i);
  std::vector<std::pair<std::size_t, std::string>> sizes;
  for (auto& [category, things] : alike) {
    if (things.size() < 2) continue;
    const auto volume = [&](std::size_t i) { return nodes[i].size.prod(); };
    std::sort(things.begin(), things.end(), [&](std::size_t a, std::size_t b) { return volume(a) < volume(b); });
    const auto second_largest = things[things.size() - 2];
    if (volume(things.back()) >= kClearlyLarger * volume(second_largest)) sizes.emplace_back(things.back(), "large");
    if (volume(things[1]) >= kClearlyLarger * volume(things[0])) sizes.emplace_back(things[0], "small");
  }
  return sizes;
}

Facts with_comparisons(const Facts& facts, const Scene& scene, const FactReader& reader, const Compared& compared) {
  Facts with = facts;
  const auto places = places_of(scene.nodes, compared);
  std::map<std::size_t, EntityIndex> known;
  for (const std::size_t place : places) {
    if (const auto entity = reader.find(scene.nodes[place].id)) known.emplace(place, *entity);
  }
  for (const NearestPair& pair : nearest_pairs(scene.nodes, places)) {
    const auto winner = known.find(pair.winner), other = known.find(pair.other);
    if (winner != known.end() && other != known.end()) with.set(Predicate::Nearest, winner->second, other->second);
  }
  for (const auto& [place, size] : sizes_of(scene.nodes, places)) {
    if (const auto thing = known.find(place); thing != known.end()) with.set(Predicate::Size, thing->second, size);
  }
  return with;
}

Trace read_state(const Scene& scene, const Compared& compared) {
  FactReader reader;
  Facts facts = reader.read(scene);
  if (!compared.none()) facts = with_comparisons(facts, scene, reader, compared);
  return {reader.entities(), {std::move(facts)}};
}

}  // namespace unietp
