#include "grounding/home_traits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/rng.h"
#include "grounding/divergence.h"

namespace unietp {
namespace {

constexpr double kStandsLow_m = 0.3;  // its underside, of what counts as standing on the floor
constexpr double kSeesPiece_m = 3;    // farthest pair that faces each other
constexpr double kFacesPiece = 0.8;   // least cosine of what faces a piece
constexpr std::size_t kCommonPairs = 50;
constexpr int kSplits = 20;

enum Trait : std::size_t {
  kRoomTypes,
  kRoomAreas,
  kJoinedRooms,
  kThingsByRoom,
  kThingsByReceptacle,
  kFurnitureDensity,
  kGapToWall,
  kTurnedToMiddle,
  kFacingPairs,
  kHeights,
  kOnFloor,
  kFreeFloor,
  kWays,
  kContainersInUse,
  kRepeats,
  kPairs,
  kTraits
};

/// A room with the furniture that stands on its floor.
struct Furnishing {
  const Room* room = nullptr;
  std::vector<const Node*> nodes, standing;
};

Vec2 middle_of(const Room& room) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& corner : room.polygon) sum += corner;
  return sum / static_cast<double>(room.polygon.size());
}

Vec2 front_of_node(const Node& node) { return rotated(node.pose.rotation, {0, -1, 0}).head<2>(); }

/// Between the box of a piece and the nearest wall of its room; 0 when it reaches into one.
double gap_to_wall(const Node& node, const Room& room) {
  const Bounds box = bounds_of(node.pose, node.size);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = room.polygon.size() - 1; i < room.polygon.size(); j = i++) {
    const Vec2 along = room.polygon[i] - room.polygon[j];
    for (const double x : {box.low.x(), box.high.x()}) {
      for (const double y : {box.low.y(), box.high.y()}) {
        const Vec2 from = Vec2(x, y) - room.polygon[j];
        const double t = std::clamp(from.dot(along) / std::max(along.squaredNorm(), 1e-9), 0.0, 1.0);
        least = std::min(least, (from - t * along).norm());
        if (!contains(room.polygon, Vec2(x, y))) least = 0;
      }
    }
  }
  return least;
}

bool face_each_other(const Node& a, const Node& b) {
  const Vec2 way = (b.pose.position - a.pose.position).head<2>();
  const double apart = way.norm();
  if (apart < 1e-6 || apart > kSeesPiece_m) return false;
  return front_of_node(a).dot(way) >= kFacesPiece * apart && front_of_node(b).dot(-way) >= kFacesPiece * apart;
}

class TraitReader {
 public:
  TraitReader(const Scene& home, const StructureNames& structure, const std::set<std::string>& types) : home_(home) {
    traits_.samples.resize(kTraits);
    for (const Room& room : home.rooms) {
      if (types.contains(room.type)) rooms_.push_back({&room, {}, {}});
    }
    traits_.rooms = static_cast<int>(rooms_.size());
    for (const Node& node : home.nodes) {
      if (structure.contains(node.category)) continue;
      const Room* room = room_at(home, node.pose.position.head<2>());
      const auto there = std::find_if(rooms_.begin(), rooms_.end(), [&](const auto& one) { return one.room == room; });
      if (there == rooms_.end()) continue;
      there->nodes.push_back(&node);
      by_id_[node.id] = &node;
      if (!node.movable && bounds_of(node.pose, node.size).low.z() < kStandsLow_m) there->standing.push_back(&node);
    }
    census_ = census_of(home, structure);
  }

  HomeTraits read() {
    for (const Furnishing& one : rooms_) read_room(one);
    read_free_floor();
    read_holding();
    read_openings();
    return std::move(traits_);
  }

 private:
  void count(Trait trait, const std::string& what) { ++traits_.samples[trait].counts[what]; }
  void add(Trait trait, double value) { traits_.samples[trait].values.push_back(value); }

  void read_room(const Furnishing& one) {
    const std::string& type = one.room->type;
    const double area = floor_area({type, one.room->polygon, {}});
    count(kRoomTypes, type);
    add(kRoomAreas, area);
    std::map<std::string, int> numbers;
    double furniture = 0;
    for (const Node* node : one.nodes) {
      count(kThingsByRoom, type + "/" + node->category);
      ++numbers[node->category];
      furniture += node->movable ? 0 : 1;
      if (node->movable) add(kHeights, bounds_of(node->pose, node->size).low.z());
    }
    if (area > 0) add(kFurnitureDensity, furniture / area);
    for (auto a = numbers.begin(); a != numbers.end(); ++a) {
      add(kRepeats, a->second);
      for (auto b = std::next(a); b != numbers.end(); ++b) count(kPairs, a->first + "+" + b->first);
    }
    int pairs = 0;
    const Vec2 middle = middle_of(*one.room);
    for (std::size_t i = 0; i < one.standing.size(); ++i) {
      const Node& node = *one.standing[i];
      add(kGapToWall, gap_to_wall(node, *one.room));
      const Vec2 way = middle - node.pose.position.head<2>();
      if (way.norm() > 1e-6) add(kTurnedToMiddle, front_of_node(node).dot(way.normalized()));
      for (std::size_t j = 0; j < i; ++j) pairs += face_each_other(node, *one.standing[j]) ? 1 : 0;
    }
    add(kFacingPairs, pairs);
  }

  void read_free_floor() {
    for (const Furnishing& one : rooms_) {
      const auto share = free_floor_share(census_.rooms[static_cast<std::size_t>(one.room - home_.rooms.data())]);
      if (share) add(kFreeFloor, *share);
    }
  }

  void read_holding() {
    std::set<std::string_view> in_use;
    double movable = 0, low = 0, containers = 0, used = 0;
    for (const Edge& edge : home_.edges) {
      const auto thing = by_id_.find(edge.from);
      if (thing == by_id_.end() || !thing->second->movable) continue;
      if (edge.relation == Predicate::OnFloor) ++low;
      const auto holder = by_id_.find(edge.to);
      if (holder == by_id_.end()) continue;
      if (edge.relation == Predicate::Inside) in_use.insert(holder->first);
      if (edge.relation == Predicate::On || edge.relation == Predicate::Inside)
        count(kThingsByReceptacle, holder->second->category);
    }
    for (const auto& [id, node] : by_id_) {
      movable += node->movable ? 1 : 0;
      if (node->movable || !node->openable) continue;
      ++containers;
      used += in_use.contains(id) ? 1 : 0;
    }
    if (movable > 0) add(kOnFloor, low / movable);
    if (containers > 0) add(kContainersInUse, used / containers);
  }

  std::optional<std::size_t> number_of(const std::string& id) const {
    const auto found =
        std::find_if(rooms_.begin(), rooms_.end(), [&](const Furnishing& one) { return one.room->id == id; });
    return found == rooms_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - rooms_.begin()));
  }

  /// Ways lead through every room, also through those that do not count.
  void read_openings() {
    const std::size_t rooms = home_.rooms.size(), points = rooms + home_.openings.size();
    const double far = std::numeric_limits<double>::infinity();
    std::vector<Vec2> at;
    for (const Room& room : home_.rooms) at.push_back(middle_of(room));
    std::vector<std::vector<std::size_t>> in_room(rooms);
    for (const Opening& opening : home_.openings) {
      for (const std::string* id : {&opening.room_a, &opening.room_b}) {
        for (std::size_t i = 0; i < rooms; ++i) {
          if (home_.rooms[i].id == *id) in_room[i].push_back(at.size());
        }
      }
      at.push_back((opening.from + opening.to) / 2);
      const auto a = number_of(opening.room_a), b = number_of(opening.room_b);
      if (!a || !b) continue;
      const auto [first, second] = std::minmax(rooms_[*a].room->type, rooms_[*b].room->type);
      count(kJoinedRooms, first + "+" + second);
    }
    std::vector<double> way(points * points, far);
    for (std::size_t i = 0; i < rooms; ++i) {
      std::vector<std::size_t> there = in_room[i];
      there.push_back(i);
      for (const std::size_t a : there) {
        for (const std::size_t b : there) way[a * points + b] = (at[a] - at[b]).norm();
      }
    }
    for (std::size_t k = 0; k < points; ++k) {
      for (std::size_t a = 0; a < points; ++a) {
        for (std::size_t b = 0; b < points; ++b)
          way[a * points + b] = std::min(way[a * points + b], way[a * points + k] + way[k * points + b]);
      }
    }
    for (std::size_t a = 0; a < rooms; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const bool counted = number_of(home_.rooms[a].id) && number_of(home_.rooms[b].id);
        if (counted && way[a * points + b] < far) add(kWays, way[a * points + b]);
      }
    }
  }

  const Scene& home_;
  std::vector<Furnishing> rooms_;
  std::map<std::string_view, const Node*> by_id_;
  HomeCensus census_;
  HomeTraits traits_;
};

/// Of two sets of values: the area between their distribution functions.
std::optional<double> wasserstein(std::vector<double> a, std::vector<double> b) {
  if (a.empty() || b.empty()) return std::nullopt;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  double area = 0, at = std::min(a.front(), b.front());
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    const double next = std::min(i < a.size() ? a[i] : b[j], j < b.size() ? b[j] : a[i]);
    const double share_a = static_cast<double>(i) / static_cast<double>(a.size());
    const double share_b = static_cast<double>(j) / static_cast<double>(b.size());
    area += std::abs(share_a - share_b) * (next - at);
    at = next;
    while (i < a.size() && a[i] <= at) ++i;
    while (j < b.size() && b[j] <= at) ++j;
  }
  return area;
}

TraitSample pooled(std::size_t trait, std::span<const HomeTraits* const> homes) {
  TraitSample all;
  for (const HomeTraits* home : homes) {
    const TraitSample& sample = home->samples[trait];
    for (const auto& [what, number] : sample.counts) all.counts[what] += number;
    all.values.insert(all.values.end(), sample.values.begin(), sample.values.end());
  }
  return all;
}

/// Leaves the commonest of b in both.
void keep_common(std::map<std::string, double>& a, std::map<std::string, double>& b) {
  std::vector<std::pair<double, std::string>> common;
  for (const auto& [what, number] : b) common.emplace_back(-number, what);
  std::sort(common.begin(), common.end());
  common.resize(std::min(common.size(), kCommonPairs));
  std::set<std::string> kept;
  for (const auto& [number, what] : common) kept.insert(what);
  for (auto* counts : {&a, &b}) std::erase_if(*counts, [&](const auto& one) { return !kept.contains(one.first); });
}

}  // namespace

const std::vector<std::pair<std::string, std::string>>& home_traits() {
  static const std::vector<std::pair<std::string, std::string>> kNames{
      {"rooms by type", ""},          {"area of a room", "m²"},
      {"joined rooms", ""},           {"things by room", ""},
      {"things by receptacle", ""},   {"furniture per m²", "1/m²"},
      {"furniture to wall", "m"},     {"turned to the middle", ""},
      {"facing pairs in a room", ""}, {"height of small things", "m"},
      {"small things on floors", ""}, {"free floor", ""},
      {"way between rooms", "m"},     {"containers in use", ""},
      {"repeats of a category", ""},  {"common pairs", ""},
  };
  return kNames;
}

HomeTraits traits_of(const Scene& home, const StructureNames& structure, const std::set<std::string>& types) {
  return TraitReader(home, structure, types).read();
}

std::optional<double> trait_distance(std::size_t trait, std::span<const HomeTraits* const> a,
                                     std::span<const HomeTraits* const> b) {
  TraitSample one = pooled(trait, a), other = pooled(trait, b);
  if (trait == kPairs) keep_common(one.counts, other.counts);
  return one.values.empty() && other.values.empty() ? divergence(one.counts, other.counts)
                                                    : wasserstein(std::move(one.values), std::move(other.values));
}

HomeComparison compare_homes(std::span<const HomeTraits> made, std::span<const HomeTraits> real) {
  HomeComparison result;
  for (const auto& [name, unit] : home_traits()) result.traits.push_back({name, unit, std::nullopt, std::nullopt});
  if (made.empty()) return result;
  const auto [fewest, most] =
      std::minmax_element(made.begin(), made.end(), [](const auto& a, const auto& b) { return a.rooms < b.rooms; });
  std::vector<const HomeTraits*> ours, theirs;
  for (const HomeTraits& home : made) ours.push_back(&home);
  for (const HomeTraits& home : real) {
    if (home.rooms >= fewest->rooms && home.rooms <= most->rooms) theirs.push_back(&home);
  }
  const std::size_t sample = std::min(ours.size(), theirs.size() / 2);
  result.made = static_cast<int>(ours.size());
  result.real = static_cast<int>(theirs.size());
  result.sample = static_cast<int>(sample);
  if (sample == 0) return result;
  std::set<std::size_t> missing;  // traits that a sample says nothing of
  Rng rng(1);
  for (int split = 0; split < kSplits; ++split) {
    rng.shuffle(ours);
    rng.shuffle(theirs);
    const std::span<const HomeTraits*const> drawn(ours), all(theirs);
    for (std::size_t trait = 0; trait < kTraits; ++trait) {
      const auto half = all.first(sample), other = all.subspan(sample, sample);
      const auto far = trait_distance(trait, drawn.first(sample), half), near = trait_distance(trait, other, half);
      if (!far || !near) missing.insert(trait);
      TraitComparison& one = result.traits[trait];
      one.made = one.made.value_or(0) + far.value_or(0) / kSplits;
      one.halves = one.halves.value_or(0) + near.value_or(0) / kSplits;
    }
  }
  for (const std::size_t trait : missing) result.traits[trait].made = result.traits[trait].halves = std::nullopt;
  return result;
}

}  // namespace unietp
