#pragma once

#include <set>
#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// A variable that a goal binds once, to one category that no other domain of the goal names. Such a one can be
/// referred to ("the dirty mug", "both dirty mugs") or described by what it is for.
struct GoalVariable {
  std::string variable, category;
  Formula::Op quantifier = Formula::Op::Exists;
  int number = 1;  // how many objects the goal needs at least; of a `forall` two
};
/// Those bound by an `exists` outside of everything else: "one mug".
std::vector<GoalVariable> singular_variables(const Formula& goal);
/// Those bound by a `forall`, `count =` or `count >=`: "all mugs", "two mugs".
std::vector<GoalVariable> counted_variables(const Formula& goal);

/// The goal with another domain for the variable, which must be one of those above.
Formula with_domain(const Formula& goal, const GoalVariable& variable, const Domain& domain);

/// Names of all variables that a formula binds, domains included.
std::vector<std::string> bound_variables(const Formula& formula);

/// The predicates of a formula, outside of its domains.
std::set<Predicate> predicates_in(const Formula& formula);

/// Every predicate that the formula applies to the variable, also inside its domains.
std::vector<Predicate> predicates_of(const Formula& formula, const std::string& variable);

}  // namespace unietp
