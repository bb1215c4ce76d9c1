#include "grounding/scene_statistics.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "grounding/divergence.h"

namespace unietp {
namespace {

constexpr double kRarePair = 0.05;

template <class Key>
void divide(std::map<Key, double>& sums, double by) {
  if (by <= 0) return;
  for (auto& [key, sum] : sums) sum /= by;
}

std::optional<double> relative_difference(double a, double b) {
  const double larger = std::max(a, b);
  if (larger <= 0) return std::nullopt;
  return std::abs(a - b) / larger;
}

using Values = std::map<std::string, double>;
using Pairs = std::map<SceneStatistics::Pair, double>;

/// Room type → share of it among all rooms.
Values shares(const Values& rooms_of_type) {
  Values result = rooms_of_type;
  divide(result, total(rooms_of_type));
  return result;
}

/// Category → mean number in a home.
Values in_homes(const Pairs& in_rooms, const Values& rooms_of_type) {
  Values sums;
  for (const auto& [key, mean] : in_rooms) sums[key.second] += mean * value_or_zero(rooms_of_type, key.first);
  return sums;
}

Values in_type(const Pairs& in_rooms, const std::string& type) {
  Values values;
  for (const auto& [key, mean] : in_rooms) {
    if (key.first == type) values[key.second] = mean;
  }
  return values;
}

std::optional<double> divergence_in_rooms(const Pairs& a, const Values& shares_a, const Pairs& b,
                                          const Values& shares_b) {
  double sum = 0, weights = 0;
  for (const auto& [type, share] : shares_a) {
    const auto other = shares_b.find(type);
    if (other == shares_b.end()) continue;
    const auto bits = divergence(in_type(a, type), in_type(b, type));
    if (!bits) continue;
    const double weight = (share + other->second) / 2;
    sum += weight * *bits;
    weights += weight;
  }
  if (weights <= 0) return std::nullopt;
  return sum / weights;
}

std::optional<double> mean_difference(const Values& a, const Values& b) {
  double sum = 0;
  int count = 0;
  for (const auto& [key, value] : a) {
    const auto other = b.find(key);
    if (other == b.end()) continue;
    sum += std::abs(value - other->second);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

std::optional<double> bray_curtis(const Pairs& a, const Pairs& b) {
  double apart = 0, both = 0;
  for (const auto& key : keys_of(a, b)) {
    const double x = value_or_zero(a, key), y = value_or_zero(b, key);
    apart += std::abs(x - y);
    both += x + y;
  }
  if (total(a) <= 0 || total(b) <= 0) return std::nullopt;
  return apart / both;
}

/// Of the types that both sets have: how their objects are spread over them when both had equally many rooms of each.
std::optional<double> spread_difference(const SceneStatistics& a, const SceneStatistics& b) {
  Values one, other;
  for (const auto& [type, mean] : a.objects_in) {
    if (!b.objects_in.contains(type)) continue;
    one[type] = mean;
    other[type] = b.objects_in.at(type);
  }
  return divergence(one, other);
}

}  // namespace

SceneStatistics statistics_of(std::span<const HomeCensus> homes, std::string source) {
  SceneStatistics s;
  s.source = std::move(source);
  s.homes = static_cast<int>(homes.size());
  Values with_floor, instances;
  double movable = 0;
  for (const HomeCensus& home : homes) {
    for (const CensusRoom& room : home.rooms) {
      ++s.rooms;
      ++s.rooms_of_type[room.type];
      s.objects += static_cast<int>(room.objects.size());
      s.objects_in[room.type] += static_cast<double>(room.objects.size());
      if (const auto share = free_floor_share(room)) {
        s.free_floor[room.type] += *share;
        s.area_m2[room.type] += floor_area(room);
        ++with_floor[room.type];
      }
      std::set<std::string> present;
      for (const CensusObject& object : room.objects) {
        (object.movable ? s.movables : s.furniture)[{room.type, object.category}] += 1;
        present.insert(object.category);
        ++instances[object.category];
        if (!object.movable) continue;
        ++movable;
        for (const std::string& holder : object.held_by) ++s.held[holder];
      }
      for (auto a = present.begin(); a != present.end(); ++a) {
        for (auto b = std::next(a); b != present.end(); ++b) s.together[{*a, *b}] += 1;
      }
    }
  }
  for (Pairs* pairs : {&s.furniture, &s.movables}) {
    for (auto& [key, sum] : *pairs) sum /= s.rooms_of_type.at(key.first);
  }
  for (auto& [type, sum] : s.objects_in) sum /= s.rooms_of_type.at(type);
  for (Values* values : {&s.free_floor, &s.area_m2}) {
    for (auto& [type, sum] : *values) sum /= with_floor.at(type);
  }
  divide(s.together, s.rooms);
  std::erase_if(s.together, [](const auto& pair) { return pair.second < kRarePair; });
  for (auto& [holder, sum] : s.held) sum /= std::max(1.0, value_or_zero(instances, holder));
  divide(s.rooms_of_type, s.homes);
  if (s.homes > 0) {
    s.rooms_per_home = static_cast<double>(s.rooms) / s.homes;
    s.objects_per_home = static_cast<double>(s.objects) / s.homes;
  }
  if (s.objects > 0) s.movable_share = movable / s.objects;
  return s;
}

SceneStatistics statistics_of(std::span<const Scene> scenes, const StructureNames& structure, std::string source) {
  std::vector<HomeCensus> homes;
  for (const Scene& scene : scenes) homes.push_back(census_of(scene, structure));
  return statistics_of(homes, std::move(source));
}

StatisticsDistance distance(const SceneStatistics& a, const SceneStatistics& b) {
  const Values shares_a = shares(a.rooms_of_type), shares_b = shares(b.rooms_of_type);
  StatisticsDistance d;
  d.rooms_per_home = relative_difference(a.rooms_per_home, b.rooms_per_home);
  d.objects_per_home = relative_difference(a.objects_per_home, b.objects_per_home);
  d.room_types = divergence(a.rooms_of_type, b.rooms_of_type);
  d.objects_in_room = spread_difference(a, b);
  d.furniture = divergence(in_homes(a.furniture, shares_a), in_homes(b.furniture, shares_b));
  d.furniture_in_room = divergence_in_rooms(a.furniture, shares_a, b.furniture, shares_b);
  d.movables = divergence(in_homes(a.movables, shares_a), in_homes(b.movables, shares_b));
  d.movables_in_room = divergence_in_rooms(a.movables, shares_a, b.movables, shares_b);
  d.free_floor = mean_difference(a.free_floor, b.free_floor);
  d.together = bray_curtis(a.together, b.together);
  d.held = divergence(a.held, b.held);
  return d;
}

std::vector<std::pair<std::string, std::optional<double>>> parts_of(const StatisticsDistance& d) {
  return {{"rooms a home", d.rooms_per_home}, {"objects a home", d.objects_per_home},
          {"room types", d.room_types},       {"objects a room", d.objects_in_room},
          {"furniture", d.furniture},         {"furniture in its rooms", d.furniture_in_room},
          {"small things", d.movables},       {"small things in their rooms", d.movables_in_room},
          {"free floor", d.free_floor},       {"what is found together", d.together},
          {"what holds things", d.held}};
}

}  // namespace unietp
