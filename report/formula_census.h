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

/// The parts of a goal that a text has to say: its different states and relations, with those by which things are
/// described (`:where`); at least 1. "Put the mug that is on the desk in a sink." has two, "first wash a mug, then put
/// it in a sink" has two, however often its formula repeats them.
int parts_of(const Formula& goal);

}  // namespace unietp
