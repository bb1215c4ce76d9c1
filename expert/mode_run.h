#pragma once

#include <optional>
#include <vector>

#include "expert/expert.h"
#include "simulation/mode_episode.h"

namespace unietp {

/// How an agent of the mode asks for the action, nullopt when it cannot; in M3 only of what shows clearly.
std::optional<Command> clearly_said(const ModeEpisode& episode, const Action& action);

/// Says the action so and does it. What cannot be said fails and does not count.
Outcome do_in(ModeEpisode& episode, const Action& action);

/// Does the actions as an agent would live them; what cannot be said is left out.
Demonstration record_in(ModeEpisode episode, const std::vector<Action>& actions);

/// Leaves out steps until none can be missed: single ones, then short runs, whatever fails for want of them included.
/// nullopt when the goal does not hold after all of them.
std::optional<std::vector<Action>> shortened(const Formula& goal, const Scene& start, const ModeEpisode& episode,
                                             std::vector<Action> actions);

}  // namespace unietp
