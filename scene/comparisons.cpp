#include "scene/comparisons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
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

/// A thing among others of its category, all in order of x.
struct Placed {
  Vec3 at;
  std::size_t thing = 0;
};
using Alike = std::vector<Placed>;

/// Which of them is nearest to a point, clearly nearer than the next, the thing `except` aside. Goes from the point's
/// own x outwards as long as there may be a nearer one.
std::optional<std::size_t> clear_winner(const Alike& alike, const Vec3& point, std::size_t except) {
  struct {
    double distance = std::numeric_limits<double>::infinity(), next = distance;  // squared
    std::size_t thing = 0;
    int found = 0;
  } best;
  const auto look = [&](const Placed& one) {
    if (one.thing == except) return;
    ++best.found;
    const double distance = (one.at - point).squaredNorm();
    if (distance < best.distance) {
      best.next = best.distance;
      best.distance = distance;
      best.thing = one.thing;
    } else if (distance < best.next) {
      best.next = distance;
    }
  };
  constexpr std::size_t kFew = 16;
  if (alike.size() <= kFew) {
    for (const Placed& one : alike) look(one);
  } else {
    const auto beyond = [&](const Placed& one) {
      const double aside = one.at.x() - point.x();
      return best.found > 1 && aside * aside > best.next;
    };
    const auto middle = std::lower_bound(alike.begin(), alike.end(), point.x(),
                                         [](const Placed& one, double x) { return one.at.x() < x; });
    auto up = middle, down = middle;
    // By turns, so that what is near on one side spares the other.
    for (bool more = true; more;) {
      more = false;
      if (up != alike.end() && !beyond(*up)) look(*up++), more = true;
      if (down != alike.begin() && !beyond(*(down - 1))) look(*--down), more = true;
    }
  }
  const bool wins =
      best.found == 1 || (best.found > 1 && clearly_nearer(std::sqrt(best.distance), std::sqrt(best.next)));
  return wins ? std::optional(best.thing) : std::nullopt;
}

}  // namespace

void Compared::add(const Formula& formula) {
  Scope scope;
  collect(formula, scope, *this);
  std::sort(categories.begin(), categories.end());
  categories.erase(std::unique(categories.begin(), categories.end()), categories.end());
}

std::vector<NearestPair> nearest_pairs(const SharedList<Node>& nodes, const std::vector<std::size_t>& places) {
  std::unordered_map<std::string_view, std::size_t> number_of_category;
  std::vector<Alike> categories;
  std::vector<Vec3> at;
  at.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Node& node = nodes[places[i]];
    const std::size_t number = number_of_category.emplace(node.category, number_of_category.size()).first->second;
    if (number == categories.size()) categories.emplace_back();
    categories[number].push_back({node.pose.position, i});
    at.push_back(node.pose.position);
  }
  for (Alike& alike : categories) {
    std::stable_sort(alike.begin(), alike.end(), [](const Placed& a, const Placed& b) { return a.at.x() < b.at.x(); });
  }
  std::vector<NearestPair> found;
  // Of each winner's next pair; at first, how many the winner before it has.
  std::vector<std::size_t> next_of(places.size() + 1, 0);
  for (std::size_t y = 0; y < places.size(); ++y) {
    for (const Alike& alike : categories) {
      const auto winner = clear_winner(alike, at[y], y);
      if (!winner) continue;
      found.push_back({*winner, y});
      ++next_of[*winner + 1];
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
