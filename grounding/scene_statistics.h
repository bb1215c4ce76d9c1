#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/result.h"
#include "grounding/home_census.h"

namespace unietp {

/// What a set of homes looks like on average. Names are the simulator's categories and the scene's room types; a table
/// is empty where no home of the set could say.
struct SceneStatistics {
  using Pair = std::pair<std::string, std::string>;

  std::string source;  // where the homes come from, for people
  int homes = 0, rooms = 0, objects = 0;
  double rooms_per_home = 0, objects_per_home = 0, movable_share = 0;
  std::map<std::string, double> rooms_of_type;  // type → mean number in a home
  std::map<std::string, double> objects_in;     // type → mean number of objects in a room of it
  std::map<std::string, double> area_m2;        // type → mean floor area
  std::map<std::string, double> free_floor;     // type → mean share of the floor over which nothing stands low
  std::map<Pair, double> furniture;             // (type, category) → mean number in a room of the type
  std::map<Pair, double> movables;              // likewise
  std::map<Pair, double> together;              // (a, b), a < b → share of all rooms with both, where at least 0.05
  std::map<std::string, double> held;           // category → mean number of movable things on or in one of it

  bool operator==(const SceneStatistics&) const = default;
};

/// Counts a set of homes. `structure`: what no statistics count. `source` names the set.
SceneStatistics statistics_of(std::span<const HomeCensus> homes, std::string source);
SceneStatistics statistics_of(std::span<const Scene> scenes, const StructureNames& structure, std::string source);

/// How far two sets of homes are apart, each part from 0 (the same) to 1 (nothing in common); nullopt where one of the
/// sets cannot say. Frequencies are compared by Jensen-Shannon divergence in bits: it is symmetric, bounded by 1, and
/// finite when a category occurs in one set only, which the Kullback-Leibler divergence is not. Means a and b are
/// compared by |a - b| / max(a, b). The room-conditional parts weigh each room type by its mean share of rooms in the
/// two sets, over the types that both have, so that what a kitchen holds does not depend on how many kitchens there
/// are. Co-occurrence is compared by Bray-Curtis dissimilarity (the sum of |a - b| over the sum of a + b): its values
/// are no distribution, and pairs seen in neither set must not count.
struct StatisticsDistance {
  std::optional<double> rooms_per_home, objects_per_home;  // means; both are asked for when homes are generated
  std::optional<double> room_types;                        // divergence of their frequencies
  std::optional<double> objects_in_room;    // divergence of how a home's objects are spread over its room types
  std::optional<double> furniture;          // divergence of categories of what does not move, whole homes
  std::optional<double> furniture_in_room;  // the same, within a room type
  std::optional<double> movables, movables_in_room;
  std::optional<double> free_floor;  // mean difference of shares
  std::optional<double> together;    // of co-occurrence
  std::optional<double> held;        // divergence of where things are kept: the share of each receptacle category
};
StatisticsDistance distance(const SceneStatistics& a, const SceneStatistics& b);

/// The parts with their names, in order; for tables.
std::vector<std::pair<std::string, std::optional<double>>> parts_of(const StatisticsDistance& distance);

/// A `*.json` of format `unietp-scene-statistics/1`; numbers are rounded to 4 decimals.
std::string statistics_to_json(const SceneStatistics& statistics);
/// Errors: Parse or Schema with line and column or a JSON pointer.
Result<SceneStatistics> statistics_from_json(std::string_view where, std::string_view text);

/// A table for people; the most frequent categories of each room type only.
std::string statistics_text(const SceneStatistics& statistics);

}  // namespace unietp
