#pragma once

#include <span>

#include "logic/formula.h"
#include "scene/trace.h"

namespace unietp {

/// Makes traces of one start: its facts are read once, each change at the cost of the change.
class TraceMaker {
 public:
  /// `comparisons`: whether some formula speaks of size or nearness; `later`: also outside of what is read at the
  /// start.
  TraceMaker(const Scene& start, bool comparisons, bool later);

  Trace at_start() const { return of({}); }
  Trace of(std::span<const Delta> changes) const;

 private:
  const Scene& start_;
  bool later_;
  FactReader reader_;
  Facts facts_;
};

}  // namespace unietp
