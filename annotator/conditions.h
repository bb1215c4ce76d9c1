#pragma once

#include <vector>

#include "logic/formula.h"

namespace unietp {

/// Conditions that follow from start constraints: from "there are fridges" and "all fridges are closed" it follows that
/// a fridge is closed, as an `exists` of a domain with a `:where`.
std::vector<Formula> conditions_of(const std::vector<Formula>& start);

/// A goal without its conditions that the start meets: "if a fridge is closed, G" is G where a fridge is closed.
/// `goal` is expanded (meaning.h), and so is the result.
Formula without_conditions(const Formula& goal, const std::vector<Formula>& start);

}  // namespace unietp
