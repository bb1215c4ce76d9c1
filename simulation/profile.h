#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/result.h"
#include "scene/action.h"
#include "scene/simulator.h"

namespace unietp {

/// The actions that a simulator offers its agent (scene/action_table.h), and its limits from
/// data/simulators/<name>.json, which gives the source of each number.
struct Profile {
  Simulator simulator = Simulator::Ai2thor;
  ActionSet actions = actions_of(Simulator::Ai2thor);
  double reach_m = 1.5;  // from the body's axis to the object's surface
  int hands = 1;
  double body_radius_m = 0.2, body_height_m = 1.6;
  double camera_height_m = 1.5;
  int image_width = 500, image_height = 500;
  double vertical_fov_deg = 90;
  double sight_m = 3.0;  // farther objects are not listed as visible
  double step_m = 0.25, turn_deg = 30, look_deg = 30;
  double most_up_deg = 30, most_down_deg = 60;  // how far the camera tilts from the level
  double max_pick_mass_kg = 50;
  bool power_needs_closed = true;                           // an appliance with a door runs only when it is shut
  bool open_needs_power_off = true;                         // and does not open while it runs
  bool slicing = true, washing = true, temperature = true;  // the simulator has these effects
  bool attaching = false;                                   // place_on attaches as the knowledge base says (`wide`)
  bool power_needs_plug = false;                            // devices with a plug run only when plugged in (`wide`)

  /// Whether the agent may do it in this simulator and profile.
  bool offers(ActionType type) const { return actions[static_cast<std::size_t>(type)]; }
};

/// Errors: Io; Parse with line and column; Schema naming the field.
Result<Profile> load_profile(const std::filesystem::path& folder, Simulator simulator,
                             ActionProfile actions = ActionProfile::Unietp);

}  // namespace unietp
