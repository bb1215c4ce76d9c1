#pragma once

#include <map>
#include <set>
#include <string>

#include "logic/formula.h"
#include "logic/trace.h"

namespace unietp {

/// For each category that a goal speaks of: the categories of receptacles and the room types that the goal relates it
/// to. What is added or moved for a start keeps away from those, so that it does not do the task's work.
using GoalPlaces = std::map<std::string, std::set<std::string>>;
/// From the atoms of the goal, wherever they stand in it.
GoalPlaces goal_places(const Formula& goal);

/// Every domain of a quantifier in the formula with its variable, outside of `:where`, outermost first.
struct QuantifiedDomain {
  Formula::Op op;  // Forall, Exists, Count or Number
  std::string variable;
  Domain domain;
  bool certain = true;  // false below `or`, `imply` and `not`: the goal may not need it, and it may be empty
};
/// In the order in which the formula has them.
std::vector<QuantifiedDomain> quantified_domains(const Formula& formula);

/// Things that a goal tells from others by a `:where` about the thing alone.
struct ReferredThings {
  QuantifiedDomain domain;
  std::vector<EntityIndex> referents, others;  // in the first state, by index; the others are of the same categories
};
/// In the order in which the goal has them. `trace` has at least one state.
std::vector<ReferredThings> referred_things(const Formula& goal, const Trace& trace);

/// Members of the domain come about by cutting.
bool makes_slices(const Domain& domain);

}  // namespace unietp
