#pragma once

#include <optional>
#include <vector>

#include "logic/formula.h"
#include "symbolic/goal.h"
#include "symbolic/perform.h"

namespace unietp::symbolic {

struct SearchOptions {
  std::size_t most_worlds = 4000;  // looked at before giving up
  std::size_t most_steps = 80;     // of a plan, before needless steps are left out
};

/// A plan for the goal from the start, found by a best-first search along the steps that Guide proposes and then made
/// minimal: no step can be left out, and the goal holds after the last step but after none before. nullopt when none
/// was found within the budget, which says little of whether there is one, or when the goal holds at the start. The
/// plan's truth is that of the logic's direct evaluator. Deterministic.
std::optional<std::vector<Step>> find_witness(const Formula& goal, const Setting& setting, const World& start,
                                              const SearchOptions& options = {});

/// The start and the world after each step; a failed step changes nothing.
std::vector<World> replay(const Setting& setting, const World& start, const std::vector<Step>& steps);

}  // namespace unietp::symbolic
