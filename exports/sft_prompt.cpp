#include <algorithm>

#include "core/text.h"
#include "exports/sft_chat.h"
#include "simulation/mode_rules.h"

namespace unietp {
namespace {

/// What is missing when an action fails so, said as a need; "" for what an agent cannot look after.
std::string need_behind(Failure failure, const Profile& profile) {
  switch (failure) {
    case Failure::Blocked:
      return "free floor";
    case Failure::NoStandingPlace:
      return "a place to stand there";
    case Failure::TooFar:
      return "it in reach (" + number_text(profile.reach_m) + " m)";
    case Failure::NotVisible:
      return "it in sight";
    case Failure::InsideClosed:
      return "nothing closed around it";
    case Failure::ReceptacleClosed:
      return "it open";
    case Failure::NotAReceptacle:
      return "something that holds things";
    case Failure::NoFreePlace:
      return "a free place there";
    case Failure::DoesNotFit:
      return "what you hold to fit";
    case Failure::NotPickupable:
      return "something that can be picked up";
    case Failure::TooHeavy:
      return "at most " + number_text(profile.max_pick_mass_kg) + " kg";
    case Failure::NotOpenable:
      return "something with a door, drawer or lid";
    case Failure::AlreadyOpen:
      return "it closed";
    case Failure::AlreadyClosed:
      return "it open";
    case Failure::NotSwitchable:
      return "something with a switch";
    case Failure::AlreadyOn:
      return "it off";
    case Failure::AlreadyOff:
      return "it on";
    case Failure::MustBeClosed:
      return "its door shut";
    case Failure::NotHolding:
      return "something in your hand";
    case Failure::HandsFull:
      return "a free hand";
    case Failure::NotSliceable:
      return "something that can be cut";
    case Failure::NoKnife:
      return "a knife in your hand";
    case Failure::NoEffect:
      return "things that go together";
    case Failure::VesselEmpty:
      return "something in the vessel that you hold";
    case Failure::NotFillable:
      return "something that holds liquids";
    case Failure::AlreadyFull:
      return "it empty";
    case Failure::NotConsumable:
      return "something that is used up";
    case Failure::NotASeat:
      return "a seat";
    case Failure::NotFoldable:
      return "something that can be folded";
    case Failure::NotBreakable:
      return "something that breaks";
    case Failure::NotPluggable:
      return "something with a plug";
    default:
      return "";
  }
}

std::string argument_words(ActionArgument argument) {
  switch (argument) {
    case ActionArgument::None:
      return "";
    case ActionArgument::Object:
      return "object";
    case ActionArgument::ObjectOrRoom:
      return "object or room";
    case ActionArgument::Tool:
      return "tool";
  }
  return "";
}

std::string action_line(const ActionInfo& action, const Profile& profile) {
  std::vector<std::string> needs;
  for (const Failure failure : failures_of(action)) {
    auto need = need_behind(failure, profile);
    if (!need.empty() && std::find(needs.begin(), needs.end(), need) == needs.end()) needs.push_back(std::move(need));
  }
  std::string line = "- " + std::string(action.name);
  if (action.argument != ActionArgument::None) line += "(" + argument_words(action.argument) + ")";
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
  const StepLimits limits = limits_of(mode);
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
  const GlobalInformation known = global_information(start, mode);
  return text + "\nWhat you know of the home:\n" + list("Rooms", known.rooms) + list("Furniture", known.furniture) +
         list("Small things", known.movables);
}

}  // namespace unietp
