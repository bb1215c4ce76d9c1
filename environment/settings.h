#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/result.h"
#include "scene/action.h"
#include "simulation/mode_rules.h"

namespace unietp {

/// What an agent is told of what its actions came to: success and the reason of a failure, success alone, or nothing.
/// With `None` no field and no text gives success away: `held` and `failures_left` are hidden as well.
enum class Feedback : std::uint8_t { Full, Success, None };
/// When reward is given: 1 at the end of an episode if the goal holds on its whole trace, else 0; or, after each step,
/// by how much the goal's progress (Monitor::progress) changed, so that the rewards of an episode add up to what was
/// gained.
enum class Reward : std::uint8_t { Success, Progress };
/// Where the paper and the runner that its authors released differ (docs/environment.md).
enum class Conventions : std::uint8_t { Paper, Release };
/// Whether an actions list goes on after one of its actions failed.
enum class OnFail : std::uint8_t { Continue, Stop };
/// The global information: lists of ids with categories, or the same grouped by room.
enum class GlobalForm : std::uint8_t { List, ByRoom };
/// Numbers of a box or point: pixels; parts of the picture's width and height, 0 to 1; thousandths of them; the same
/// with y before x. Said boxes are read and told boxes are written in this form.
enum class BoxForm : std::uint8_t { Pixels, Unit, Thousand, ThousandYFirst };

/// All values of each setting, in the order in which errors list them.
inline constexpr std::array kTeleports{Teleport::Nothing, Teleport::Rooms, Teleport::Furniture, Teleport::Anything};
inline constexpr std::array kNamings{Naming::None, Naming::Id, Naming::Box};
inline constexpr std::array kFeedbacks{Feedback::Full, Feedback::Success, Feedback::None};
inline constexpr std::array kRewards{Reward::Success, Reward::Progress};
inline constexpr std::array kConventions{Conventions::Paper, Conventions::Release};
inline constexpr std::array kOnFails{OnFail::Continue, OnFail::Stop};
inline constexpr std::array kGlobalForms{GlobalForm::List, GlobalForm::ByRoom};
inline constexpr std::array kBoxForms{BoxForm::Pixels, BoxForm::Unit, BoxForm::Thousand, BoxForm::ThousandYFirst};
// Names of the values in settings: "anything", "id", "none", "progress", "release", "continue", "by_room", "unit".
std::string_view name_of(Teleport teleport);
std::string_view name_of(Naming naming);
std::string_view name_of(Feedback feedback);
std::string_view name_of(Reward reward);
std::string_view name_of(Conventions conventions);
std::string_view name_of(OnFail on_fail);
std::string_view name_of(GlobalForm form);
std::string_view name_of(BoxForm form);

/// How an environment treats its agent. The defaults are the paper's M1.
struct Settings {
  ModeRules rules;  // what the mode fixes, each column of it
  Conventions conventions = Conventions::Paper;
  Feedback feedback = Feedback::Full;
  Reward reward = Reward::Success;
  OnFail on_fail = OnFail::Continue;
  GlobalForm global = GlobalForm::List;
  bool floor_plan = false;  // the home on a map, and where the agent stands in it
  BoxForm box_form = BoxForm::Pixels;
  int image_width = 0, image_height = 0;  // pixels; 0: those of the simulator's profile
  bool operator==(const Settings&) const = default;
};
/// The preset of a mode: M2 and M3 with a floor plan. `Release` sets `rules.invalid_is_free` and `box_form` unit and
/// has no floor plan; the rest is alike.
Settings settings_for(Mode mode, Conventions conventions = Conventions::Paper);

/// Errors: Usage, naming the setting, for values out of range and for combinations that cannot be kept: with feedback
/// `none`, free invalid actions or a list that stops at a failure would show in `steps_left` what failed.
Result<Done> check(const Settings& settings);

/// The names of all settings in their order: "mode", "conventions", "picture", "boxes", "rooms", "furniture",
/// "movables", "teleport", "reach", "move", "atomic", "composite", "steps", "failures", "invalid", "feedback",
/// "reward", "on_fail", "global", "floor_plan", "box_form", "image_width", "image_height".
const std::vector<std::string>& setting_names();
/// Every setting by its name: {"mode": "M1", "picture": true, "teleport": "anything", "steps": 50, "invalid":
/// "counts", …}.
nlohmann::ordered_json settings_to_json(const Settings& settings);
/// The preset of "mode" and "conventions" (M1 and paper when they are missing), then every other field that is there,
/// one after the other. Errors: Usage, naming the field, for unknown names and values; those of `check`.
Result<Settings> settings_from_json(std::string_view where, const nlohmann::ordered_json& json);

}  // namespace unietp
