#include "scene/size_and_nearness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace unietp {
namespace {

/// An object of a category, with its center; the objects of a category are sorted by x.
struct Placed {
  Vec3 at;
  std::size_t thing = 0;
};
using Alike = std::vector<Placed>;

/// The object nearest to a point, if clearly nearer than the second nearest; `except` is skipped. Searches outward from
/// the point's x and stops where no nearer object can follow.
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
    // Alternates between the two sides, so that a near object on one side ends the search on the other.
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

bool clearly_nearer(double distance_m, double other_m) {
  return other_m - distance_m >= std::max(kClearlyNearer_m, kClearlyNearer * distance_m);
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
  // Where the next pair of each winner goes; before that, the number of pairs of the winner before it.
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

}  // namespace unietp
