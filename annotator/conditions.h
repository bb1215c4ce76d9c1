#pragma once

#include <vector>

#include "logic/formula.h"

namespace unietp {

/// What start constraints say that there is, as conditions that are met: that there are fridges and that all are closed
/// is that a fridge is closed, an `exists` of nothing but a domain with a `:where`.
std::vector<Formula> conditions_of(const std::vector<Formula>& start);

/// A goal without its conditions that the start meets: "if a fridge is closed, G" is G where a fridge is closed.
/// `goal` is expanded (meaning.h), and so is the result.
Formula without_conditions(const Formula& goal, const std::vector<Formula>& start);

}  // namespace unietp
