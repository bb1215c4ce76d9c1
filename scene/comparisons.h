#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"
#include "logic/trace.h"
#include "scene/scene.h"
#include "scene/trace.h"

namespace unietp {

/// The objects for which a formula asks `size` or `nearest`. Comparing all objects of a scene takes time quadratic in
/// their number, and most formulas name only one or two categories.
struct Compared {
  bool all = false;                     // every thing
  std::vector<std::string> categories;  // else those of these categories and slices of them

  /// Whether nothing is compared.
  bool none() const { return !all && categories.empty(); }
  /// Adds what a closed formula, or one of its domains, compares.
  void add(const Formula& formula);
};

/// `facts`, which `reader` read from the scene without comparisons, with those of `compared` added. A formula that
/// compares nothing else has the same value on the result as on a reading with all comparisons.
Facts with_comparisons(const Facts& facts, const Scene& scene, const FactReader& reader, const Compared& compared);

/// A scene as a trace of length one, with these comparisons.
Trace read_state(const Scene& scene, const Compared& compared);

}  // namespace unietp
