#pragma once

#include <span>

#include "logic/formula.h"
#include "scene/trace.h"

namespace unietp {

/// Makes traces that begin in one start scene. The facts of the start are computed once, later ones from the changes.
class TraceMaker {
 public:
  /// `comparisons`: whether some formula compares sizes or distances; `later`: also in states after the start.
  TraceMaker(const Scene& start, bool comparisons, bool later);

  Trace at_start() const { return of({}); }        // of one state
  Trace of(std::span<const Delta> changes) const;  // the start, then a state after each change

 private:
  const Scene& start_;
  bool later_;
  FactReader reader_;
  Facts facts_;
};

}  // namespace unietp
