#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "expert/demonstration.h"
#include "expert/execution_tree.h"
#include "simulation/mode_rules.h"

namespace unietp {

/// A plan in which what it opens is closed and what it turns on is turned off again: each thing that was not so at the
/// start and would be so at the end is set back in as few steps as can be, and as soon as can be without anything else
/// becoming impossible. Left as it is is what the goal needs so, and what could not be set back within the limits of
/// the rules. `actions` ends with `stop`, which stays, and works; the first `done` stay as they are. `opened`: what was
/// opened before the start of the tree, and so is to be closed too. Deterministic.
std::vector<Action> tidied(ExecutionTree& executions, const ModeRules& rules, std::vector<Action> actions,
                           std::size_t done = 0, const std::vector<std::string>& opened = {});

/// Marks the steps that only set back what the demonstration did before: a `close` of what it opened or a `turn_off` of
/// what it turned on, without which the rest, done by one who has been told where everything is, reaches the goal as
/// well, and the steps right before it that only lead there.
/// Each is judged without those that are marked before it, so that all of them can be left out together.
void mark_tidying(ExecutionTree& executions, Demonstration& demonstration);

}  // namespace unietp
