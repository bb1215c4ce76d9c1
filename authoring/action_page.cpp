#include "authoring/action_page.h"

#include "core/text.h"
#include "scene/action.h"

namespace unietp {
namespace {

constexpr std::string_view kHead =
    "# Actions by simulator, mode and profile\n"
    "\n"
    "Written by `unietp actions --page` from the catalogue (`scene/action.cpp`) and the profiles\n"
    "(`data/simulators/`); a test holds it to them, and another goes through it row by row in each simulator\n"
    "(`tests/simulation/action_table_test.cpp`). [actions.md](actions.md) says how to read it.\n";

std::string row(const std::vector<std::string>& cells) { return "| " + join(cells, " | ") + " |\n"; }

std::string head(const std::vector<std::string>& titles) {
  return "\n" + row(titles) + "|" + join(std::vector<std::string>(titles.size(), "---|"), "") + "\n";
}

std::string_view text_of(ActionArgument argument) {
  switch (argument) {
    case ActionArgument::None:
      return "none";
    case ActionArgument::Object:
      return "object";
    case ActionArgument::ObjectOrRoom:
      return "object or room";
    case ActionArgument::Tool:
      return "tool";
  }
  return "";
}

std::string_view text_of(ActionClass group) {
  switch (group) {
    case ActionClass::Movement:
      return "movement";
    case ActionClass::Reach:
      return "reach";
    case ActionClass::Manipulation:
      return "manipulation";
    case ActionClass::Composite:
      return "composite";
    case ActionClass::Control:
      return "control";
  }
  return "";
}

/// In which profiles a simulator offers an action.
std::string offer(ActionType type, const Profile& plain, const Profile& wide) {
  if (plain.offers(type)) return wide.offers(type) ? "yes" : "unietp";
  return wide.offers(type) ? "wide" : "–";
}

std::string actions(const std::vector<Profile>& plain, const std::vector<Profile>& wide) {
  std::vector<std::string> titles{"#", "action", "argument", "class", "M1", "M2", "M3"};
  for (const Simulator simulator : kSimulators) titles.emplace_back(name_of(simulator));
  titles.emplace_back("effect");
  std::string table = "\n## Who offers what\n" + head(titles);
  int number = 0;
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      std::vector<std::string> cells{std::to_string(++number), std::string(action.name),
                                     std::string(text_of(action.argument)), std::string(text_of(action.group))};
      for (const bool mode : {action.m1, action.m2, action.m3}) cells.emplace_back(mode ? "yes" : "–");
      for (std::size_t i = 0; i < plain.size(); ++i) cells.push_back(offer(action.type, plain[i], wide[i]));
      cells.emplace_back(action.effect);
      table += row(cells);
    }
  }
  return table;
}

std::string counts(const std::vector<Profile>& plain, const std::vector<Profile>& wide) {
  const auto count = [](const ActionSet& set, Mode mode) {
    std::size_t offered = 0;
    for (const auto list : {all_actions(), extension_actions()}) {
      for (const ActionInfo& action : list)
        offered += set[static_cast<std::size_t>(action.type)] && unietp::offers(action, mode) ? 1 : 0;
    }
    return std::to_string(offered);
  };
  std::string table = "\n## How many\n" + head({"profile", "simulator", "M1", "M2", "M3"});
  const auto add = [&](std::string_view profile, std::string_view simulator, const ActionSet& set) {
    table += row({std::string(profile), std::string(simulator), count(set, Mode::M1), count(set, Mode::M2),
                  count(set, Mode::M3)});
  };
  for (const auto* profiles : {&plain, &wide}) {
    const std::string_view name = name_of(profiles == &plain ? ActionProfile::Unietp : ActionProfile::Wide);
    ActionSet any;
    for (const Profile& profile : *profiles) any |= profile.actions;
    add(name, "all", any);
    for (const Profile& profile : *profiles) add(name, name_of(profile.simulator), profile.actions);
  }
  return table;
}

std::string needs() {
  std::string table =
      "\n## What each needs\n\nThe failure that tells that a need is not met, in the order of checking. Every action "
      "can also fail as\n"
      "`invalid_argument` and `not_offered`; composite actions also with what their steps fail with. `seated` is told "
      "only\n"
      "where one can sit, `not_plugged_in` only where plugs matter.\n" +
      head({"action", "failures"});
  for (const auto list : {all_actions(), extension_actions()}) {
    for (const ActionInfo& action : list) {
      std::vector<std::string> names;
      for (const Failure failure : action.failures) names.emplace_back(name_of(failure));
      table += row({std::string(action.name), names.empty() ? "–" : join(names, ", ")});
    }
  }
  return table;
}

std::string limits(const std::vector<Profile>& plain, const std::vector<Profile>& wide) {
  std::vector<std::string> titles{"limit"};
  for (const Profile& profile : plain) titles.emplace_back(name_of(profile.simulator));
  std::string table =
      "\n## What limits the agent\n\nEach figure's source stands in `data/simulators/`.\n" + head(titles);
  const auto add = [&](const char* name, const std::vector<Profile>& profiles, const auto& value) {
    std::vector<std::string> cells{name};
    for (const Profile& profile : profiles) cells.push_back(value(profile));
    table += row(cells);
  };
  const auto yes = [](bool flag) { return std::string(flag ? "yes" : "–"); };
  add("reach, m", plain, [](const Profile& p) { return number_text(p.reach_m); });
  add("hands", plain, [](const Profile& p) { return std::to_string(p.hands); });
  add("body: radius, height, m", plain,
      [](const Profile& p) { return number_text(p.body_radius_m) + ", " + number_text(p.body_height_m); });
  add("camera height, m", plain, [](const Profile& p) { return number_text(p.camera_height_m); });
  add("image, pixels", plain,
      [](const Profile& p) { return std::to_string(p.image_width) + " x " + std::to_string(p.image_height); });
  add("vertical field of view, degrees", plain, [](const Profile& p) { return number_text(p.vertical_fov_deg); });
  add("objects are listed up to, m", plain, [](const Profile& p) { return number_text(p.sight_m); });
  add("step, m", plain, [](const Profile& p) { return number_text(p.step_m); });
  add("turn, tilt, degrees", plain,
      [](const Profile& p) { return number_text(p.turn_deg) + ", " + number_text(p.look_deg); });
  add("tilts from up to down, degrees", plain,
      [](const Profile& p) { return "-" + number_text(p.most_up_deg) + " to " + number_text(p.most_down_deg); });
  add("lifts at most, kg", plain, [](const Profile& p) { return number_text(p.max_pick_mass_kg); });
  add("appliances run only shut", plain, [&](const Profile& p) { return yes(p.power_needs_closed); });
  add("and open only when off", plain, [&](const Profile& p) { return yes(p.open_needs_power_off); });
  add("slicing", plain, [&](const Profile& p) { return yes(p.slicing); });
  add("washing, filling, soaking", plain, [&](const Profile& p) { return yes(p.washing); });
  add("heating, cooling, cooking", plain, [&](const Profile& p) { return yes(p.temperature); });
  add("`wide`: place_on attaches", wide, [&](const Profile& p) { return yes(p.attaching); });
  add("`wide`: runs only plugged in", wide, [&](const Profile& p) { return yes(p.power_needs_plug); });
  return table;
}

}  // namespace

std::string action_page(const std::vector<Profile>& plain, const std::vector<Profile>& wide) {
  return std::string(kHead) + actions(plain, wide) + counts(plain, wide) + needs() + limits(plain, wide);
}

}  // namespace unietp
