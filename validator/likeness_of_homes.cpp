#include "validator/likeness_of_homes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "core/sort_unique.h"
#include "scene/room_finder.h"
#include "simulation/digest.h"

namespace unietp {
namespace {

constexpr std::size_t kNeighbors = 8;  // of each thing; more give no sharper picture
constexpr std::uint64_t kTolerance_mm = 50;
constexpr int kDistanceBits = 24;
constexpr std::uint64_t kMostDistance_mm = (std::uint64_t{1} << kDistanceBits) - 1;

/// A thing as the prints see it: where its middle is, and hashes of what it is.
struct Thing {
  Vec3 position = Vec3::Zero();
  std::uint64_t category = 0, size = 0;
};

std::uint64_t hash_of_size(const Vec3& size) {
  const auto centimeters = [](double meters) { return static_cast<std::uint64_t>(std::llround(meters * 100)); };
  return Digester()
      .add(centimeters(std::min(size.x(), size.y())))
      .add(centimeters(std::max(size.x(), size.y())))
      .add(centimeters(size.z()))
      .digest()
      .a;
}

/// The middle of a polygon's area, which does not move when a corner is added on one of its sides.
Vec2 middle_of(const std::vector<Vec2>& polygon) {
  Vec2 sum = Vec2::Zero();
  double twice_area = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = polygon[j] - polygon[0], b = polygon[i] - polygon[0];
    const double cross = a.x() * b.y() - a.y() * b.x();
    sum += cross * (a + b);
    twice_area += cross;
  }
  return twice_area == 0 ? polygon[0] : Vec2(polygon[0] + sum / (3 * twice_area));
}

/// The things that are compared among each other: those of each room with the room itself, those in no room, the rooms.
std::vector<std::vector<Thing>> groups_of(const Scene& home) {
  std::vector<std::vector<Thing>> groups(home.rooms.size() + 2);
  const RoomFinder rooms(home.rooms);
  for (const Node& node : home.nodes) {
    const auto room = rooms.at(node.pose.position.head<2>());
    groups[room ? *room : home.rooms.size()].push_back(
        {node.pose.position, Digester().add(node.category).digest().a, hash_of_size(node.size)});
  }
  for (std::size_t i = 0; i < home.rooms.size(); ++i) {
    const Room& room = home.rooms[i];
    if (room.polygon.empty()) continue;
    const Vec2 middle = middle_of(room.polygon);
    const Thing thing{{middle.x(), middle.y(), 0}, Digester().add("room " + room.type).digest().a, 0};
    groups[i].push_back(thing);
    groups.back().push_back(thing);
  }
  return groups;
}

std::uint64_t pair_of(std::uint64_t a, std::uint64_t b, std::uint64_t distance_mm) {
  const std::uint64_t both = Digester().add(std::min(a, b)).add(std::max(a, b)).digest().a;
  return (both << kDistanceBits) | distance_mm;
}

void add_pairs(const std::vector<Thing>& things, HomeFingerprint& print) {
  using Neighbor = std::tuple<std::uint64_t, std::uint64_t, std::size_t>;  // distance, category, place
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<Neighbor> others;
  const auto distance = [&things](std::size_t i, std::size_t j) {
    const double meters = (things[i].position - things[j].position).norm();
    return static_cast<std::uint64_t>(std::min(meters * 1000, static_cast<double>(kMostDistance_mm)));
  };
  for (std::size_t i = 0; i < things.size(); ++i) {
    others.clear();
    for (std::size_t j = 0; j < things.size(); ++j) {
      if (j != i) others.emplace_back(distance(i, j), things[j].category, j);
    }
    const std::size_t near = std::min(kNeighbors, others.size());
    std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(near), others.end());
    for (std::size_t n = 0; n < near; ++n) {
      const std::size_t j = std::get<2>(others[n]);
      pairs.emplace_back(std::min(i, j), std::max(i, j));
    }
  }
  sort_unique(pairs);
  for (const auto& [i, j] : pairs) {
    print.by_category.push_back(pair_of(things[i].category, things[j].category, distance(i, j)));
    print.by_size.push_back(pair_of(things[i].size, things[j].size, distance(i, j)));
  }
}

/// As many pairs of the two sorted lists as can be matched one to one: the first that is near enough, which leaves the
/// most to the others. Distances stay so far below the highest that numbers of different things are never near.
double share_of_smaller(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  std::size_t i = 0, j = 0, matched = 0;
  while (i < a.size() && j < b.size()) {
    if (a[i] > b[j] + kTolerance_mm) {
      ++j;
    } else if (b[j] > a[i] + kTolerance_mm) {
      ++i;
    } else {
      ++matched, ++i, ++j;
    }
  }
  const std::size_t smaller = std::min(a.size(), b.size());
  return smaller == 0 ? 0 : static_cast<double>(matched) / static_cast<double>(smaller);
}

}  // namespace

HomeFingerprint print_of_home(const Scene& home) {
  HomeFingerprint print;
  for (const auto& things : groups_of(home)) add_pairs(things, print);
  std::sort(print.by_category.begin(), print.by_category.end());
  std::sort(print.by_size.begin(), print.by_size.end());
  return print;
}

double likeness_of_homes(const HomeFingerprint& a, const HomeFingerprint& b) {
  return std::max(share_of_smaller(a.by_category, b.by_category), share_of_smaller(a.by_size, b.by_size));
}

}  // namespace unietp
