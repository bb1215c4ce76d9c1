#pragma once

#include <memory>
#include <string>
#include <vector>

#include "environment/answer.h"
#include "environment/observation.h"
#include "environment/settings.h"
#include "simulation/mode_episode.h"

namespace unietp {

// What the environment tells an agent of its world, made only from the world and the settings.

/// Whether the agent knows objects by ids at all.
bool tells_ids(const ModeRules& rules);

/// The lists of the home, as far as the rules tell of it, at the start of an episode.
std::shared_ptr<const HomeInformation> home_information(const World& start, const Settings& settings);

/// The objects in view before the next step; the rules must tell boxes.
std::vector<ObservedObject> visible_objects(const ModeEpisode& episode);

/// What is in the hands, without ids where objects have none.
std::vector<HeldObject> held_objects(const World& world, const ModeRules& rules);

/// An executed command as the agent is told of it. Names of objects are repeated only where objects have ids, names of
/// actions only where there is such an action, and nothing without feedback. `frame`: of its boxes.
ActionReport report_of(const Command& command, const Outcome& outcome, const World& world, const Settings& settings,
                       const AnswerFrame& frame);

}  // namespace unietp
