#pragma once

#include <string>
#include <vector>

#include "logic/formula.h"

namespace unietp {

/// A variable that a goal binds once, by an `exists` outside of everything else, to one category that no other domain
/// of the goal names: "one mug". Such a one can be referred to ("the dirty mug") or described by what it is for.
struct GoalVariable {
  std::string variable, category;
};
std::vector<GoalVariable> singular_variables(const Formula& goal);

/// The goal with another domain for the variable, which must be one of singular_variables.
Formula with_domain(const Formula& goal, const std::string& variable, const Domain& domain);

/// Names of all variables that a formula binds, domains included.
std::vector<std::string> bound_variables(const Formula& formula);

/// Every predicate that the formula applies to the variable, also inside its domains.
std::vector<Predicate> predicates_of(const Formula& formula, const std::string& variable);

}  // namespace unietp
