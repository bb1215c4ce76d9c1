#pragma once

#include <string>
#include <vector>

#include "environment/observation.h"
#include "environment/settings.h"
#include "scene/scene.h"
#include "scene/visible_object.h"
#include "simulation/profile.h"

namespace unietp {

// What an agent is told in words. The environment, the SFT export and evaluation use these functions and no others, so
// that an agent meets in one the texts that it learned from in another. All are deterministic.

/// Before the episode: what the agent is, its actions with what they need, how to answer, the rules of naming, and what
/// it may know of the home in advance; without a line feed at its end. `reasoning`: it is asked for a rationale.
/// `profile` gives the size of the image.
std::string system_prompt(const Scene& start, const Settings& settings, const Profile& profile, bool reasoning);

/// The actions alone: one line for each that the rules and the simulator offer, with what it needs.
std::string action_space_text(const ModeRules& rules, const Profile& profile);

/// How objects and rooms are named, and where the agent may go at once; a paragraph, or "" where nothing is named.
std::string naming_text(const Settings& settings, const Profile& profile);
/// Rooms, furniture and small things of the home at the start, one line each, or on request a line for each room, as
/// far as the rules tell of them; then the floor plan, where it is told.
std::string home_text(const Scene& start, const Settings& settings);

/// "Task: Put a mug on the table."
std::string task_text(const std::string& instruction);
/// "In view: mug_1 [10,20,30,40]; table_1 [0,0,9,9]." or "Nothing is in view."
std::string view_text(const std::vector<VisibleObject>& visible);
/// "The last action succeeded." or "The last action failed. Your hands are empty."
std::string outcome_text(bool success, const std::string& feedback);
/// "pick_up(mug_1): succeeded", for a history.
std::string history_text(const std::string& action, bool success, const std::string& feedback);

/// "Your actions so far:" and a numbered line for each history_text; with `only_last` "Your last actions:". "" for
/// none.
std::string actions_text(const std::vector<std::string>& actions, bool only_last);

/// What became of the last action, or of each action of a list as numbered lines; "" where it is not told.
std::string results_text(const std::vector<ActionReport>& results);
/// The objects in view of an observation, with boxes in the settings' form; "" where they are not told.
std::string boxes_text(const Observation& observation, const Settings& settings);
/// Where the agent stands and what is in view, a line each, as far as they are told.
std::string view_text(const Observation& observation, const Settings& settings);

/// An observation as the user's turn of a chat: the task at the start, afterwards what became of the last action, or of
/// each action of a list as numbered lines of a history; then where the agent stands, and what is in view. As much as
/// the settings tell; the picture is sent beside it. "" when there is nothing to tell.
std::string observation_text(const Observation& observation, const Settings& settings);

/// A box in the numbers of a form, four of them in its order; in `Unit` with three decimals.
std::vector<double> box_in_form(const PixelBox& box, BoxForm form, int width, int height);

}  // namespace unietp
