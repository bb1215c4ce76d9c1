#pragma once

#include <optional>

#include "expert/explorer.h"
#include "expert/search_problem.h"
#include "expert/window.h"

namespace unietp {

/// Stage: reaches a goal in M2 or M3 by what can be known there. It looks for the things that the goal and its tools
/// need, in the order in which such things are usually found, plans in a world made of what it believes as soon as it
/// has seen enough, does the plan, and plans anew when it sees what it did not expect. In M3, where the furniture has
/// to be found, too, it looks around in rooms, and before it acts on a thing it brings it into the picture. Ends with
/// `stop` once it believes that the goal is reached. nullopt then; else why it gave up. Every action is a function of
/// the problem and of what the window showed before it. Deterministic.
std::optional<Trouble> reach_by_belief(const SearchProblem& problem, Window& window);

}  // namespace unietp
