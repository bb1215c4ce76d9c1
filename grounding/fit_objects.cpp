#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "akb/csv.h"
#include "akb/knowledge.h"
#include "akb/table_words.h"
#include "akb/tables.h"
#include "core/text.h"
#include "grounding/layout_fit.h"

namespace unietp {
namespace {

constexpr double kSeldom = 0.02;  // means below are left to the share of what was not seen
constexpr double kLeastUnseen = 0.01, kMostUnseen = 0.15;
constexpr double kMovableShare = 0.45;  // where no real home says
constexpr double kFloorShare = 0.06;    // likewise
constexpr double kOnFloor_m = 0.1;      // the lowest part of what is on nothing lies below that
constexpr double kLikeRoom = 0.5;       // of a thing's mean in another room, in a usual room that no real home shows

using ByWord = std::map<std::pair<std::string, std::string>, double>;  // (room, display) → mean

/// What the homes of other simulators show, by the words for people: the mean over those that have the room and the
/// word.
ByWord means_by_word(const FitInput& own, std::span<const FitInput> all) {
  ByWord sums;
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const FitInput& other : all) {
    if (other.knowledge == own.knowledge) continue;
    for (const auto& [type, number] : other.statistics.objects_in) {
      for (const Category& category : other.knowledge->categories()) {
        if (!category.movable) continue;
        const auto mean = other.statistics.movables.find({type, category.name});
        if (mean == other.statistics.movables.end()) continue;
        sums[{type, category.display}] += mean->second;
        ++counts[{type, category.display}];
      }
    }
  }
  for (auto& [key, sum] : sums) sum /= counts.at(key);
  return sums;
}

/// Categories that only slicing makes.
std::set<std::string> slices(const Knowledge& knowledge) {
  std::set<std::string> names;
  for (const Effect& effect : knowledge.effects()) {
    if (effect.treatment == Treatment::Slices && effect.gives != effect.target) names.insert(effect.gives);
  }
  return names;
}

/// Good and Turing's estimate of how much of what one meets was never met before: the share of things met once.
double unseen_share(const FitInput& own) {
  std::map<std::string, int> counts;
  int total = 0;
  for (const HomeCensus& home : own.homes.homes) {
    for (const CensusRoom& room : home.rooms) {
      for (const CensusObject& object : room.objects) {
        if (!object.movable) continue;
        ++counts[object.category];
        ++total;
      }
    }
  }
  if (total == 0) return kMostUnseen;
  const auto once = std::count_if(counts.begin(), counts.end(), [](const auto& one) { return one.second == 1; });
  return std::clamp(static_cast<double>(once) / total, kLeastUnseen, kMostUnseen);
}

/// Of the small things, those that are on or in nothing and low; nullopt where no home has poses.
std::optional<double> floor_share(const FitInput& own) {
  int low = 0, total = 0;
  for (const HomeCensus& home : own.homes.homes) {
    for (const CensusRoom& room : home.rooms) {
      for (const CensusObject& object : room.objects) {
        if (!object.movable || !object.box) continue;
        ++total;
        low += object.held_by.empty() && object.box->low.z() < kOnFloor_m ? 1 : 0;
      }
    }
  }
  return total > 0 ? std::optional(static_cast<double>(low) / total) : std::nullopt;
}

}  // namespace

std::string fit_objects(const FitInput& own, std::span<const FitInput> all) {
  const ByWord words = means_by_word(own, all);
  const std::set<std::string> cut = slices(*own.knowledge);
  const bool real = !own.homes.homes.empty();
  std::string out = "room,category,mean,source\n";
  out += csv_line({"any", "all", rounded_text(real ? own.statistics.movable_share : kMovableShare),
                   real ? own.homes.source : "curated"});
  out += csv_line({"any", "unseen", rounded_text(unseen_share(own)), real ? "derived:good-turing" : "curated"});
  const auto low = floor_share(own);
  out += csv_line({"any", "floor", rounded_text(low.value_or(kFloorShare)), low ? own.homes.source : "curated"});
  for (const std::string& room : room_types()) {
    for (const Category& category : own.knowledge->categories()) {
      if (!category.movable || cut.contains(category.name)) continue;
      const auto mean_in = [&](const std::string& type) {
        const auto found = own.statistics.movables.find({type, category.name});
        return found == own.statistics.movables.end() ? 0.0 : found->second;
      };
      double most = 0;
      for (const auto& [type, number] : own.statistics.objects_in) most = std::max(most, mean_in(type));
      const bool usual = std::find(category.rooms.begin(), category.rooms.end(), room) != category.rooms.end();
      double mean = 0;
      std::string source;
      if (most > 0 && own.statistics.objects_in.contains(room)) {
        mean = mean_in(room);
        source = own.homes.source;
      } else if (most > 0) {
        mean = usual ? kLikeRoom * most : 0;
        source = "derived:usual-room";
      } else if (const auto word = words.find({room, category.display}); word != words.end()) {
        mean = word->second;
        source = "derived:same-word";
      }
      if (mean >= kSeldom) out += csv_line({room, category.name, rounded_text(mean), source});
    }
  }
  return out;
}

std::string fit_receptacles(const FitInput& own, std::span<const FitInput> all) {
  std::map<std::string, std::pair<double, int>> by_word;
  for (const FitInput& other : all) {
    for (const auto& [name, mean] : other.statistics.held) {
      const Category* category = other.knowledge->find(name);
      if (category == nullptr || other.knowledge == own.knowledge) continue;
      by_word[category->display].first += mean;
      ++by_word[category->display].second;
    }
  }
  std::string out = "category,mean,source\n";
  for (const Category& category : own.knowledge->categories()) {
    const auto held = own.statistics.held.find(category.name);
    if (held != own.statistics.held.end()) {
      out += csv_line({category.name, rounded_text(held->second), own.homes.source});
    } else if (const auto word = by_word.find(category.display); word != by_word.end()) {
      out += csv_line({category.name, rounded_text(word->second.first / word->second.second), "derived:same-word"});
    }
  }
  return out;
}

}  // namespace unietp
