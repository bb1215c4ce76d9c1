#pragma once

#include <string>
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

/// Facts that `reader` read of the scene without comparisons, and what comes of comparing these things: all that
/// formulas which compare no others can tell from a reading with every comparison.
Facts with_comparisons(const Facts& facts, const Scene& scene, const FactReader& reader, const Compared& compared);

/// A scene as a trace of length one, with these comparisons.
Trace read_state(const Scene& scene, const Compared& compared);

}  // namespace unietp
