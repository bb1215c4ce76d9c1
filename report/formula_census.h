#pragma once

#include <set>
#include <string>

#include "logic/formula.h"

namespace unietp {

/// The operators and predicates of a goal, by their names in docs/logic.md, with those of `:where`.
struct FormulaCensus {
  std::set<std::string> operators;  // "exists", "at-end", "count", "where"
  std::set<std::string> predicates;
};
/// Deterministic.
FormulaCensus census_of(const Formula& goal);

}  // namespace unietp
