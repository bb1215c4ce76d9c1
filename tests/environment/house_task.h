#pragma once

#include <string>

#include "environment/environment.h"

namespace unietp::testing {

/// The house of tests/expert/house.h, ready to be acted in; the goal decides what an episode is for.
SharedTask house_task(const std::string& goal = "(exists (?x - Mug) (exists (?y - SideTable) (at-end (on ?x ?y))))");

/// An environment of that task.
Environment house_environment(const Settings& settings, const std::string& goal = "");

/// How an agent says an action: {"action": "pick_up", "args": ["mug_1"]}.
std::string say(const std::string& action, const std::string& id = "");

}  // namespace unietp::testing
