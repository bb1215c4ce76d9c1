#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulation/world.h"

namespace unietp {

/// What an action is done for, besides that it succeeds.
struct Postcondition {
  std::function<bool(const World&)> reached;  // true of the world afterwards; may be empty
  std::function<bool(const Pose&)> at;        // true of where the held thing is let go; may be empty
};

/// The cheapest steps known to another place to stand, from which an action succeeds and reaches its aim: the agent
/// goes to the object or room `about` which it is, to what is on or in that, or to furniture nearby, and walks a few
/// steps. Found by doing it in copies of the world. nullopt when nothing within the search does. Deterministic.
std::optional<std::vector<Action>> steps_to_act(const World& world, const Action& action, const std::string& about,
                                                const Postcondition& aim);

}  // namespace unietp
