#include "scene/action.h"

#include <array>

#include "core/text.h"

namespace unietp {
namespace {

constexpr ActionInfo row(ActionType type, std::string_view name, ActionArgument argument, ActionClass group,
                         std::string_view simulators, std::string_view effect) {
  const auto in = [simulators](char letter) { return simulators.find(letter) != std::string_view::npos; };
  const bool atomic = group != ActionClass::Composite;  // composites are for planners on symbols: M1 only
  return {type, name, argument, group, true, atomic, atomic, in('A'), in('V'), in('H'), in('B'), effect};
}

using enum ActionType;
using enum ActionArgument;
using enum ActionClass;

// A = AI2-THOR, V = VirtualHome, H = Habitat, B = BEHAVIOR.
constexpr std::array<ActionInfo, kActionCount> kActions{
    row(MoveForward, "move_forward", None, Movement, "AVHB", "the agent takes a step ahead"),
    row(MoveBackward, "move_backward", None, Movement, "AHB", "the agent takes a step back"),
    row(MoveLeft, "move_left", None, Movement, "AHB", "the agent takes a step to its left"),
    row(MoveRight, "move_right", None, Movement, "AHB", "the agent takes a step to its right"),
    row(TurnLeft, "turn_left", None, Movement, "AVHB", "the agent turns left on the spot"),
    row(TurnRight, "turn_right", None, Movement, "AVHB", "the agent turns right on the spot"),
    row(LookUp, "look_up", None, Movement, "AHB", "the camera tilts up"),
    row(LookDown, "look_down", None, Movement, "AHB", "the camera tilts down"),
    row(TurnBaseToLook, "turn_base_to_look", None, Movement, "H", "the body turns to where the head looks"),
    row(ResetHead, "reset_head", None, Movement, "H", "the head looks straight ahead again"),
    row(MoveHandForward, "move_hand_forward", None, Movement, "A", "the held object moves away from the body"),
    row(MoveHandBackward, "move_hand_backward", None, Movement, "A", "the held object moves towards the body"),
    row(MoveHandLeft, "move_hand_left", None, Movement, "A", "the held object moves left"),
    row(MoveHandRight, "move_hand_right", None, Movement, "A", "the held object moves right"),
    row(RotateHand, "rotate_hand", None, Movement, "A", "the held object turns in the hand"),
    row(GoTo, "go_to", ObjectOrRoom, Reach, "AVHB", "the agent stands by the object, or in the room"),
    row(TurnTo, "turn_to", Object, Reach, "AVHB", "the agent faces the object and looks at it"),
    row(PickUp, "pick_up", Object, Manipulation, "AVHB", "the object is held and lies nowhere any more"),
    row(PlaceOn, "place_on", Object, Manipulation, "AVHB", "the held object is let down on the object"),
    row(PlaceIn, "place_in", Object, Manipulation, "AVHB", "the held object is let down inside the object"),
    row(Drop, "drop", None, Manipulation, "AHB", "the held object falls to the floor"),
    row(Open, "open", Object, Manipulation, "AVHB", "the object is open"),
    row(Close, "close", Object, Manipulation, "AVHB", "the object is closed"),
    row(TurnOn, "turn_on", Object, Manipulation, "AVB", "the object is on; a tap washes and fills what is under it"),
    row(TurnOff, "turn_off", Object, Manipulation, "AVB", "the object is off"),
    row(Slice, "slice", Object, Manipulation, "AB", "the object is sliced and its slices exist; needs a held knife"),
    row(PourTo, "pour_to", Object, Manipulation, "AB",
        "the held vessel is empty and the object filled; a drain stays empty"),
    row(UseUp, "use_up", Object, Manipulation, "A", "the object is used up"),
    row(Wipe, "wipe", Object, Manipulation, "B",
        "the object is clean and uncovered; needs a held cloth, soaked for stains"),
    row(SpreadTo, "spread_to", Object, Manipulation, "B", "the object is covered with what the held dispenser gives"),
    row(SoakWith, "soak_with", Tool, Manipulation, "B", "the held object is soaked"),
    row(HeatWith, "heat_with", Tool, Composite, "A", "the held object is hot"),
    row(CoolWith, "cool_with", Tool, Composite, "AB", "the held object is cool; in a freezer it is frozen"),
    row(WashWith, "wash_with", Tool, Composite, "AB",
        "the held object is clean; a tap leaves a vessel filled with water"),
    row(CookWith, "cook_with", Tool, Composite, "AB", "the held object is cooked and hot"),
    row(BurnWith, "burn_with", Tool, Composite, "B", "the held object is burnt"),
    row(FillWith, "fill_with", Tool, Composite, "AB", "the held object is filled with what the tool gives"),
    row(Stop, "stop", None, Control, "AVHB", "the episode ends"),
};

constexpr bool in_enum_order() {
  for (std::size_t i = 0; i < kActions.size(); ++i) {
    if (static_cast<std::size_t>(kActions[i].type) != i) return false;
  }
  return true;
}
static_assert(in_enum_order());

constexpr std::size_t kFailureCount = static_cast<std::size_t>(Failure::NotReady) + 1;
constexpr std::array<std::string_view, kFailureCount> kFailureNames{
    "none",          "invalid_action",    "invalid_argument", "not_offered",
    "blocked",       "no_standing_place", "too_far",          "not_visible",
    "inside_closed", "receptacle_closed", "not_a_receptacle", "no_free_place",
    "did_not_rest",  "does_not_fit",      "not_pickupable",   "too_heavy",
    "not_openable",  "already_open",      "already_closed",   "not_switchable",
    "already_on",    "already_off",       "must_be_closed",   "not_holding",
    "hands_full",    "not_sliceable",     "no_knife",         "no_effect",
    "vessel_empty",  "not_fillable",      "already_full",     "not_consumable",
    "not_ready",
};

}  // namespace

std::string_view name_of(Mode mode) {
  switch (mode) {
    case Mode::M1:
      return "M1";
    case Mode::M2:
      return "M2";
    case Mode::M3:
      return "M3";
  }
  return "";
}

const ActionInfo& info(ActionType type) { return kActions[static_cast<std::size_t>(type)]; }

std::optional<ActionType> action_named(std::string_view name) {
  for (const ActionInfo& action : kActions) {
    if (action.name == name) return action.type;
  }
  return std::nullopt;
}

std::span<const ActionInfo> all_actions() { return kActions; }

bool offers(const ActionInfo& action, Simulator simulator) {
  switch (simulator) {
    case Simulator::Ai2thor:
      return action.ai2thor;
    case Simulator::Virtualhome:
      return action.virtualhome;
    case Simulator::Habitat:
      return action.habitat;
    case Simulator::Behavior:
      return action.behavior;
  }
  return false;
}

bool offers(const ActionInfo& action, Mode mode) {
  switch (mode) {
    case Mode::M1:
      return action.m1;
    case Mode::M2:
      return action.m2;
    case Mode::M3:
      return action.m3;
  }
  return false;
}

std::string to_text(const Action& action) {
  std::string text(info(action.type).name);
  return action.args.empty() ? text : text + "(" + join(action.args, ", ") + ")";
}

std::string_view name_of(Failure failure) {
  const auto index = static_cast<std::size_t>(failure);
  return index < kFailureNames.size() ? kFailureNames[index] : std::string_view();
}

std::optional<Failure> failure_named(std::string_view name) {
  for (std::size_t i = 0; i < kFailureNames.size(); ++i) {
    if (kFailureNames[i] == name) return static_cast<Failure>(i);
  }
  return std::nullopt;
}

}  // namespace unietp
