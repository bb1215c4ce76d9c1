#pragma once

#include <utility>
#include <vector>

#include "expert/subgoal.h"

namespace unietp {

/// What failed attempts taught: a penalty on truths and on things, in actions.
struct CostPenalties {
  std::vector<std::pair<Literal, double>> literals;
  std::vector<std::pair<EntityIndex, double>> things;
  /// 0 for what was never part of a failure.
  double penalty(const Literal& literal) const;
  double penalty(EntityIndex thing) const;
};

/// Estimated actions for an alternative; shared trips, doors and cuts are counted once.
double estimate(const Alternative& alternative, const Situation& situation, const CostPenalties& experience);

}  // namespace unietp
