#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "grounding/home_census.h"
#include "scene/scene.h"

namespace unietp {

/// What one home shows of one trait: how often each of several things is there, or measured values.
struct TraitSample {
  std::map<std::string, double> counts;
  std::vector<double> values;
};

/// The traits of one home, in the order of home_traits().
struct HomeTraits {
  int rooms = 0;
  std::vector<TraitSample> samples;
};

/// The names of the traits with the unit of their values, "" for counts and shares:
/// rooms by type; floor area of a room; which types of rooms are joined by an opening; categories by type of room;
/// movable things by the category that they are on or in; furniture per square meter of a room; the gap between
/// furniture on the floor and the nearest wall; the cosine of the angle between its front and the direction to the
/// room's middle; pairs of furniture in a room that face each other within 3 m; the height of the underside of movable
/// things; the share of them that is on the floor; the share of a room's floor that is free; the length of the way
/// from one room's middle to another's by the middles of the openings; the share of the furniture with doors, drawers
/// or lids that holds something; how many of one category are in a room; the pairs of categories in one room.
const std::vector<std::pair<std::string, std::string>>& home_traits();

/// The traits of a home. `types`: the types of rooms that count; with what is in the others they are left out.
/// `structure`: the categories that do not count.
HomeTraits traits_of(const Scene& home, const StructureNames& structure, const std::set<std::string>& types);

/// How far two sets of homes are apart in a trait: the Jensen-Shannon divergence in bits of counts, the Wasserstein
/// distance of values in their unit. nullopt when a set has nothing. Of pairs of categories the 50 commonest of `b`
/// count.
std::optional<double> trait_distance(std::size_t trait, std::span<const HomeTraits* const> a,
                                     std::span<const HomeTraits* const> b);

/// One trait of made homes against real ones.
struct TraitComparison {
  std::string trait, unit;
  std::optional<double> made;    // the distance between made homes and real ones
  std::optional<double> halves;  // between two halves of the real homes
};

/// Compares made homes with real ones of like size, those with no fewer rooms than the made home with the fewest and no
/// more than that with the most. Each distance is the mean of 20 random splits: the real homes fall into halves of
/// equal size, as many made homes are drawn, and they are compared with one half, and the halves with each other. All
/// sets have the same size, because distances of small sets are larger. With fewer than two real homes of like size
/// nothing has a distance. Deterministic.
struct HomeComparison {
  int made = 0, real = 0;  // homes of like size
  int sample = 0;          // homes in each set that was compared
  std::vector<TraitComparison> traits;
};
HomeComparison compare_homes(std::span<const HomeTraits> made, std::span<const HomeTraits> real);

}  // namespace unietp
