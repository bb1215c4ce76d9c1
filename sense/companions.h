#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "sense/items.h"
#include "sense/kinds.h"

namespace unietp {

/// Which kinds of things people need for one activity: in how many of the activities that they described two kinds
/// occur together. An activity is an activity definition of BEHAVIOR or all programs of VirtualHome with one title;
/// votes and placements speak of no activity. Kinds occur in it as things and as places.
class Companions {
 public:
  using Pair = std::pair<std::string, std::string>;  // the first is not after the second
  Companions() = default;
  /// `activities` of both kinds of each pair, of one kind where both are the same; the whole number in all.
  Companions(std::map<Pair, int> activities, int all) : activities_(std::move(activities)), all_(all) {}

  /// How much more often the kind occurs in an activity that has the others than in any: the mean over the others, each
  /// (n(both) + p) / (n(other) + 1) / p with p = (n(kind) + 0.3) / (all + 1). Below 1 it is rarer beside them. nullopt
  /// without others.
  std::optional<double> among(std::string_view kind, const std::set<std::string>& others) const;
  /// True where the two occur together less than half as often as by chance, and chance would have them together in at
  /// least one activity.
  bool strangers(std::string_view a, std::string_view b) const;

  /// The table: in how many activities two kinds occur together; and the number of all activities.
  const std::map<Pair, int>& activities() const { return activities_; }
  int all() const { return all_; }

 private:
  int count(std::string_view a, std::string_view b) const;

  std::map<Pair, int> activities_;
  int all_ = 0;
};

/// The kinds of a role: the thing and, of a role of place, what it is on, in or next to.
std::set<std::string> kinds_of(const Evidence& item, const Kinds& kinds);

/// The kinds of each activity, by source and group. Items that do not count and those of votes and placements are left
/// out.
std::map<std::pair<std::string, std::string>, std::set<std::string>> kinds_of_activities(std::span<const Item> items,
                                                                                         const Kinds& kinds);

/// Counts how often kinds occur together, in the activities of each source.
std::map<std::string, Companions> count_companions(std::span<const Item> items, const Kinds& kinds);
/// Those of all sources in one.
Companions add_up(const std::map<std::string, Companions>& by_source);

/// companions.csv (thing,other,activities,source): for each source a row for each pair that occurs, for each kind with
/// itself, and one of the root with itself for all activities.
std::string csv_of(const std::map<std::string, Companions>& by_source, const Kinds& kinds);
/// All sources in one. Errors are appended: Io, Parse; Schema for an unknown kind, and for a pair of a source that
/// stands twice or the wrong way around.
Companions read_companions(const std::filesystem::path& path, const Kinds& kinds, std::vector<Error>& errors);

}  // namespace unietp
