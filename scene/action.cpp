#include "scene/action.h"

#include <algorithm>
#include <array>

#include "core/text.h"

namespace unietp {
namespace {

using enum ActionType;
using enum ActionArgument;
using enum ActionClass;
using F = Failure;

// Why actions fail, in the order in which they check what they need.
constexpr std::array<F, 0> kNever{};
constexpr std::array kWalking{F::Seated, F::Blocked};
constexpr std::array kTurning{F::Seated};
constexpr std::array kTilting{F::Blocked};
constexpr std::array kHandMoving{F::NotHolding, F::Blocked};
constexpr std::array kGoing{F::Seated, F::NoStandingPlace};
constexpr std::array kFacing{F::NotVisible};
constexpr std::array kPicking{F::NotPickupable, F::Seated,     F::HandsFull, F::InsideClosed,
                              F::TooFar,        F::NotVisible, F::TooHeavy};
constexpr std::array kPlacingOn{F::NotHolding,     F::InsideClosed, F::TooFar,      F::NotVisible,
                                F::NotAReceptacle, F::DoesNotFit,   F::NoFreePlace, F::DidNotRest};
constexpr std::array kPlacingIn{F::NotHolding,     F::InsideClosed, F::TooFar,      F::NotVisible, F::ReceptacleClosed,
                                F::NotAReceptacle, F::DoesNotFit,   F::NoFreePlace, F::DidNotRest};
constexpr std::array kDropping{F::NotHolding, F::Blocked, F::DidNotRest};
constexpr std::array kOpening{F::NotOpenable, F::InsideClosed, F::TooFar, F::NotVisible,
                              F::AlreadyOpen, F::AlreadyOn,    F::Blocked};
constexpr std::array kClosing{F::NotOpenable, F::InsideClosed, F::TooFar, F::NotVisible, F::AlreadyClosed, F::Blocked};
constexpr std::array kTurningOn{F::NotSwitchable, F::InsideClosed, F::TooFar,      F::NotVisible,
                                F::AlreadyOn,     F::MustBeClosed, F::NotPluggedIn};
constexpr std::array kTurningOff{F::NotSwitchable, F::InsideClosed, F::TooFar, F::NotVisible, F::AlreadyOff};
constexpr std::array kSlicing{F::NotSliceable, F::NoKnife, F::InsideClosed, F::TooFar, F::NotVisible};
constexpr std::array kPouring{F::NotHolding, F::VesselEmpty, F::InsideClosed, F::TooFar,
                              F::NotVisible, F::NotFillable, F::AlreadyFull};
constexpr std::array kUsingUp{F::NotConsumable, F::InsideClosed, F::TooFar, F::NotVisible};
constexpr std::array kWiping{F::NotHolding, F::NoEffect, F::InsideClosed, F::TooFar, F::NotVisible, F::NotReady};
constexpr std::array kSpreading{F::NotHolding, F::NoEffect, F::InsideClosed, F::TooFar, F::NotVisible};
// A step of a composite action fails with its own reason.
constexpr std::array kTreating{F::NotHolding, F::NoEffect, F::InsideClosed, F::TooFar, F::NotVisible, F::NoFreePlace};
constexpr std::array kSitting{F::NotASeat, F::Seated, F::InsideClosed, F::TooFar, F::NotVisible, F::NoFreePlace};
constexpr std::array kStanding{F::NotSeated};
constexpr std::array kPluggingIn{F::NotPluggable, F::InsideClosed, F::TooFar, F::NotVisible, F::AlreadyPluggedIn};
constexpr std::array kUnplugging{F::NotPluggable, F::InsideClosed, F::TooFar, F::NotVisible, F::AlreadyUnplugged};
constexpr std::array kFolding{F::NotFoldable, F::AlreadyFolded, F::HandsFull, F::InsideClosed,
                              F::TooFar,      F::NotVisible,    F::Blocked};
constexpr std::array kBreaking{F::NotBreakable, F::AlreadyBroken, F::InsideClosed, F::TooFar, F::NotVisible};

constexpr ActionInfo row(ActionType type, std::string_view name, ActionArgument argument, ActionClass group,
                         std::string_view simulators, std::span<const Failure> failures, std::string_view effect) {
  const auto in = [simulators](char letter) { return simulators.find(letter) != std::string_view::npos; };
  const bool atomic = group != ActionClass::Composite;  // composites are for planners on symbols: M1 only
  return {type, name, argument, group, true, atomic, atomic, in('A'), in('V'), in('H'), in('B'), effect, failures};
}

// A = AI2-THOR, V = VirtualHome, H = Habitat, B = BEHAVIOR.
constexpr std::array<ActionInfo, kActionCount> kActions{
    row(MoveForward, "move_forward", None, Movement, "AVHB", kWalking, "the agent takes a step ahead"),
    row(MoveBackward, "move_backward", None, Movement, "AHB", kWalking, "the agent takes a step back"),
    row(MoveLeft, "move_left", None, Movement, "AHB", kWalking, "the agent takes a step to its left"),
    row(MoveRight, "move_right", None, Movement, "AHB", kWalking, "the agent takes a step to its right"),
    row(TurnLeft, "turn_left", None, Movement, "AVHB", kTurning, "the agent turns left on the spot"),
    row(TurnRight, "turn_right", None, Movement, "AVHB", kTurning, "the agent turns right on the spot"),
    row(LookUp, "look_up", None, Movement, "AHB", kTilting, "the camera tilts up"),
    row(LookDown, "look_down", None, Movement, "AHB", kTilting, "the camera tilts down"),
    row(TurnBaseToLook, "turn_base_to_look", None, Movement, "H", kNever, "the body turns to where the head looks"),
    row(ResetHead, "reset_head", None, Movement, "H", kNever, "the head looks straight ahead again"),
    row(MoveHandForward, "move_hand_forward", None, Movement, "A", kHandMoving,
        "the held object moves away from the body"),
    row(MoveHandBackward, "move_hand_backward", None, Movement, "A", kHandMoving,
        "the held object moves towards the body"),
    row(MoveHandLeft, "move_hand_left", None, Movement, "A", kHandMoving, "the held object moves left"),
    row(MoveHandRight, "move_hand_right", None, Movement, "A", kHandMoving, "the held object moves right"),
    row(RotateHand, "rotate_hand", None, Movement, "A", kHandMoving, "the held object turns in the hand"),
    row(GoTo, "go_to", ObjectOrRoom, Reach, "AVHB", kGoing, "the agent stands by the object, or in the room"),
    row(TurnTo, "turn_to", Object, Reach, "AVHB", kFacing, "the agent faces the object and looks at it"),
    row(PickUp, "pick_up", Object, Manipulation, "AVHB", kPicking, "the object is held and lies nowhere any more"),
    row(PlaceOn, "place_on", Object, Manipulation, "AVHB", kPlacingOn, "the held object is let down on the object"),
    row(PlaceIn, "place_in", Object, Manipulation, "AVHB", kPlacingIn, "the held object is let down inside the object"),
    row(Drop, "drop", None, Manipulation, "AHB", kDropping, "the held object falls to the floor"),
    row(Open, "open", Object, Manipulation, "AVHB", kOpening, "the object is open"),
    row(Close, "close", Object, Manipulation, "AVHB", kClosing, "the object is closed"),
    row(TurnOn, "turn_on", Object, Manipulation, "AVB", kTurningOn,
        "the object is on; a tap washes and fills what is under it"),
    row(TurnOff, "turn_off", Object, Manipulation, "AVB", kTurningOff, "the object is off"),
    row(Slice, "slice", Object, Manipulation, "AB", kSlicing,
        "the object is sliced and its slices exist; needs a held knife"),
    row(PourTo, "pour_to", Object, Manipulation, "AB", kPouring,
        "the held vessel is empty and the object filled; a drain stays empty"),
    row(UseUp, "use_up", Object, Manipulation, "A", kUsingUp, "the object is used up"),
    row(Wipe, "wipe", Object, Manipulation, "B", kWiping,
        "the object is clean and uncovered; needs a held cloth, soaked for stains"),
    row(SpreadTo, "spread_to", Object, Manipulation, "B", kSpreading,
        "the object is covered with what the held dispenser gives"),
    row(SoakWith, "soak_with", Tool, Manipulation, "B", kTreating, "the held object is soaked"),
    row(HeatWith, "heat_with", Tool, Composite, "A", kTreating, "the held object is hot"),
    row(CoolWith, "cool_with", Tool, Composite, "AB", kTreating, "the held object is cool; in a freezer it is frozen"),
    row(WashWith, "wash_with", Tool, Composite, "AB", kTreating,
        "the held object is clean; a tap leaves a vessel filled with water"),
    row(CookWith, "cook_with", Tool, Composite, "AB", kTreating, "the held object is cooked and hot"),
    row(BurnWith, "burn_with", Tool, Composite, "B", kTreating, "the held object is burnt"),
    row(FillWith, "fill_with", Tool, Composite, "AB", kTreating, "the held object is filled with what the tool gives"),
    row(Stop, "stop", None, Control, "AVHB", kNever, "the episode ends"),
    row(SitOn, "sit_on", Object, Manipulation, "V", kSitting, "the agent sits on the object"),
    row(LieOn, "lie_on", Object, Manipulation, "V", kSitting, "the agent lies on the object"),
    row(StandUp, "stand_up", None, Movement, "V", kStanding, "the agent stands beside what it sat or lay on"),
    row(PlugIn, "plug_in", Object, Manipulation, "V", kPluggingIn, "the object is plugged in"),
    row(Unplug, "unplug", Object, Manipulation, "V", kUnplugging, "the object is unplugged, and off"),
    row(Fold, "fold", Object, Manipulation, "B", kFolding, "the object is folded"),
    row(Break, "break", Object, Manipulation, "A", kBreaking, "the object is broken; what filled it is gone"),
};

constexpr bool in_enum_order() {
  for (std::size_t i = 0; i < kActions.size(); ++i) {
    if (static_cast<std::size_t>(kActions[i].type) != i) return false;
  }
  return true;
}
static_assert(in_enum_order());

constexpr std::size_t kDefaultCount = static_cast<std::size_t>(Stop) + 1;
constexpr bool is_small_move(ActionType type) { return type >= TurnBaseToLook && type <= RotateHand; }

constexpr std::array<std::string_view, kFailureCount> kFailureNames{
    "none",
    "invalid_action",
    "invalid_argument",
    "not_offered",
    "blocked",
    "no_standing_place",
    "too_far",
    "not_visible",
    "inside_closed",
    "receptacle_closed",
    "not_a_receptacle",
    "no_free_place",
    "did_not_rest",
    "does_not_fit",
    "not_pickupable",
    "too_heavy",
    "not_openable",
    "already_open",
    "already_closed",
    "not_switchable",
    "already_on",
    "already_off",
    "must_be_closed",
    "not_holding",
    "hands_full",
    "not_sliceable",
    "no_knife",
    "no_effect",
    "vessel_empty",
    "not_fillable",
    "already_full",
    "not_consumable",
    "not_ready",
    "not_a_seat",
    "seated",
    "not_seated",
    "not_pluggable",
    "already_plugged_in",
    "already_unplugged",
    "not_plugged_in",
    "not_foldable",
    "already_folded",
    "not_breakable",
    "already_broken",
    "not_in_view",
    "not_seen_yet",
    "no_object_there",
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

std::optional<Mode> mode_named(std::string_view name) {
  const auto* found = std::find_if(kModes.begin(), kModes.end(), [name](Mode mode) { return name_of(mode) == name; });
  return found == kModes.end() ? std::nullopt : std::optional(*found);
}

std::string_view name_of(ActionProfile profile) { return profile == ActionProfile::Wide ? "wide" : "unietp"; }

std::optional<ActionProfile> action_profile_named(std::string_view name) {
  for (const auto profile : {ActionProfile::Unietp, ActionProfile::Wide}) {
    if (name_of(profile) == name) return profile;
  }
  return std::nullopt;
}

const ActionInfo& info(ActionType type) { return kActions[static_cast<std::size_t>(type)]; }

std::optional<ActionType> action_named(std::string_view name) {
  for (const ActionInfo& action : kActions) {
    if (action.name == name) return action.type;
  }
  return std::nullopt;
}

std::span<const ActionInfo> all_actions() { return std::span(kActions).first(kDefaultCount); }
std::span<const ActionInfo> extension_actions() { return std::span(kActions).subspan(kDefaultCount); }

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

ActionSet actions_of(Simulator simulator, ActionProfile profile) {
  ActionSet set;
  for (const ActionInfo& action : kActions) {
    const bool extension = static_cast<std::size_t>(action.type) >= kDefaultCount;
    const bool in_profile = profile == ActionProfile::Wide ? !is_small_move(action.type) : !extension;
    set[static_cast<std::size_t>(action.type)] = in_profile && offers(action, simulator);
  }
  return set;
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
