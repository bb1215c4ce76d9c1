#pragma once

#include <string>
#include <utility>
#include <vector>

#include "logic/formula.h"
#include "logic/trace.h"
#include "scene/scene.h"
#include "scene/trace.h"

namespace unietp {

/// The things whose `size` or `nearest` something asks for. Comparing all of a scene costs the square of what it holds;
/// most formulas name two categories.
struct Compared {
  bool all = false;                     // every thing
  std::vector<std::string> categories;  // else those of these categories and slices of them

  bool none() const { return !all && categories.empty(); }
  /// Also what a closed formula or one of its domains compares.
  void add(const Formula& formula);
};

/// x is `nearest` to y, by places in the list of nodes.
struct NearestPair {
  std::size_t winner = 0, other = 0;
};
/// Among the nodes at these places (which hold all of a category or none); by winner, then by what it is nearest to.
std::vector<NearestPair> nearest_pairs(const SharedList<Node>& nodes, const std::vector<std::size_t>& places);
/// Those that have a size among their category, with "large" or "small".
std::vector<std::pair<std::size_t, std::string>> sizes_of(const SharedList<Node>& nodes,
                                                          const std::vector<std::size_t>& places);

/// Facts that `reader` read of the scene without comparisons, and what comes of comparing these things: all that
/// formulas which compare no others can tell from a reading with every comparison.
Facts with_comparisons(const Facts& facts, const Scene& scene, const FactReader& reader, const Compared& compared);

/// A scene as a trace of length one, with these comparisons.
Trace read_state(const Scene& scene, const Compared& compared);

}  // namespace unietp
