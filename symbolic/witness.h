#pragma once

#include <optional>
#include <vector>

#include "logic/formula.h"
#include "symbolic/goal.h"
#include "symbolic/perform.h"

namespace unietp::symbolic {

/// The budget of a search.
struct SearchOptions {
  std::size_t most_worlds = 4000;  // looked at before giving up
  std::size_t most_steps = 80;     // of a plan, before needless steps are left out
};

/// A plan for the goal, found by a best-first search along the steps that Heuristic proposes, then made minimal: no
/// step can be left out, and the goal holds after the last step and after none before. nullopt when the goal holds at
/// the start, or when the budget was used up, which does not mean that there is no plan. Truth is decided by the direct
/// evaluator of logic/. Deterministic.
std::optional<std::vector<Step>> find_witness(const Formula& goal, const Setting& setting, const World& start,
                                              const SearchOptions& options = {});

/// The start and the worlds that each step leads through; a failed step changes nothing.
std::vector<World> replay(const Setting& setting, const World& start, const std::vector<Step>& steps);

}  // namespace unietp::symbolic
