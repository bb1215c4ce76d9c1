#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "expert/demonstration.h"
#include "generator/specification.h"
#include "grounding/episode.h"

namespace unietp {

/// The properties over which a data set is balanced. `Use`: the kind of the thing that a text calls by what it is for.
enum class Dimension { Template, Category, Receptacle, Room, Scene, Use };
/// Number of dimensions.
inline constexpr std::size_t kDimensionCount = static_cast<std::size_t>(Dimension::Use) + 1;
std::string_view name_of(Dimension dimension);  // "receptacle"
std::optional<Dimension> dimension_named(std::string_view name);

/// `Receptacle` for a placeholder that other objects are put on or in: second in a placement constraint, or with the
/// affordance of a receptacle or a container. `Room` for a room type, else `Category`.
Dimension dimension_of(const Parameter& parameter, const Template& source);

/// The value of a task in one dimension. Names that depend on the simulator begin with it: "ai2thor/Mug".
struct Trait {
  Dimension dimension = Dimension::Template;
  std::string value;
  bool operator==(const Trait&) const = default;
};

/// Template, home, each bound category (colors and materials are none), and the types of the rooms in which the objects
/// that the demonstration handles are at the start; each once, sorted.
std::vector<Trait> traits_of(const Template& source, const Episode& episode, const Demonstration& demonstration);

/// One per line: "room ai2thor/kitchen". The second reads that text and skips lines that it cannot read.
std::string to_text(const std::vector<Trait>& traits);
std::vector<Trait> traits_from(std::string_view text);

/// How evenly the tasks are distributed over the values of a dimension.
struct Spread {
  Dimension dimension = Dimension::Template;
  int values = 0;        // that some task has
  double effective = 0;  // 1 / sum of squared shares: as many equally frequent values would be as diverse
  double variation = 0;  // standard deviation of the counts over their mean; 0 when all are equal
};

/// How often each value was used.
class Frequencies {
 public:
  /// Counts values; a share counts as that part of one.
  void add(const Trait& trait, double share = 1) { counts_[index(trait.dimension)][trait.value] += share; }
  void add(const std::vector<Trait>& traits) {
    for (const auto& trait : traits) add(trait);
  }
  /// The shares added so far; 0 for a new value.
  double count(Dimension dimension, const std::string& value) const;
  /// How much a value is wanted: 1 for a new one, falling with the square of how often it was used.
  double weight(Dimension dimension, const std::string& value) const;
  /// In the order of the enum; dimensions without any value are left out.
  std::vector<Spread> spreads() const;

 private:
  static std::size_t index(Dimension dimension) { return static_cast<std::size_t>(dimension); }
  std::array<std::map<std::string, double>, kDimensionCount> counts_;
};

}  // namespace unietp
