#include <algorithm>

#include "core/text.h"
#include "exports/sft_chat.h"
#include "simulation/mode_rules.h"

namespace unietp {
namespace {

/// What an action needs that fails so when it is missing; "" for what an agent cannot look after.
std::string need_behind(Failure failure, const Profile& profile) {
  const std::string need = replace_all(std::string(info(failure).need), "{reach_m}", number_text(profile.reach_m));
  return replace_all(need, "{mass_kg}", number_text(profile.max_pick_mass_kg));
}

std::string action_line(const ActionInfo& action, const Profile& profile) {
  std::vector<std::string> needs;
  for (const Failure failure : failures_of(action)) {
    auto need = need_behind(failure, profile);
    if (!need.empty() && std::find(needs.begin(), needs.end(), need) == needs.end()) needs.push_back(std::move(need));
  }
  std::string line = "- " + std::string(action.name);
  if (action.argument != ActionArgument::None) line += "(" + std::string(name_of(action.argument)) + ")";
  line += ": " + std::string(action.effect);
  return line + (needs.empty() ? "" : "; needs " + join(needs, ", ")) + ".\n";
}

std::string naming_rules(Mode mode, const Profile& profile) {
  switch (mode) {
    case Mode::M1:
      return "Name objects and rooms by their ids. You may go to any of them.\n";
    case Mode::M2:
      return "Name objects and rooms by their ids. You may go to rooms, furniture and small things that are in view "
             "now;"
             " everything else can be done to furniture and to small things that you have seen.\n";
    case Mode::M3:
      return "Name an object by the box around it in the picture, {\"bbox\": [x0, y0, x1, y1]}: pixels from the upper "
             "left corner of a picture " +
             std::to_string(profile.image_width) + " wide and " + std::to_string(profile.image_height) +
             " high, both ends included. Rooms have ids; you may go to one. What you hold has no box and needs none.\n";
  }
  return "";
}

std::string list(const std::string& title, const std::vector<std::string>& ids) {
  return ids.empty() ? "" : title + ": " + join(ids, ", ") + ".\n";
}

}  // namespace

std::string system_prompt(const Scene& start, Mode mode, const Profile& profile, bool reasoning) {
  const StepLimits limits = rules_of(mode).limits;
  std::string text =
      "You are a robot in a home and carry out a task, one action at a time. Before each action you are told what "
      "became "
      "of the one before and what your camera shows. When the task is done, answer with stop. You have at most " +
      std::to_string(limits.steps) + " actions, of which at most " + std::to_string(limits.failures) + " may fail.\n\n";
  text += "Answer with nothing but a JSON object: {";
  if (reasoning) text += "\"reasoning\": \"one to three sentences\", ";
  text += "\"action\": \"NAME\", \"args\": [ARGUMENT]}, with \"args\": [] for an action that takes none.\n";
  text += naming_rules(mode, profile) + "\nActions:\n";
  for (const ActionInfo& action : all_actions()) {
    if (profile.offers(action.type) && offers(action, mode)) text += action_line(action, profile);
  }
  for (const ActionInfo& action : extension_actions()) {
    if (profile.offers(action.type) && offers(action, mode)) text += action_line(action, profile);
  }
  const GlobalInformation known = global_information(start, rules_of(mode));
  return text + "\nWhat you know of the home:\n" + list("Rooms", known.rooms) + list("Furniture", known.furniture) +
         list("Small things", known.movables);
}

}  // namespace unietp
