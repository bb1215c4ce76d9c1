#pragma once

#include <set>
#include <string>

#include "logic/formula.h"

namespace unietp {

/// Which operators and predicates a goal has, by their names in docs/logic.md; what a `:where` says is counted too.
struct FormulaCensus {
  std::set<std::string> operators;  // "exists", "at-end", "count", "where"
  std::set<std::string> predicates;
};
FormulaCensus census_of(const Formula& goal);

}  // namespace unietp
