#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/simulator.h"

namespace unietp {

/// The 38 action types and the seven of the profile `wide`, numbered as in docs/actions.md.
enum class ActionType : std::uint8_t {
  MoveForward,
  MoveBackward,
  MoveLeft,
  MoveRight,
  TurnLeft,
  TurnRight,
  LookUp,
  LookDown,
  TurnBaseToLook,
  ResetHead,
  MoveHandForward,
  MoveHandBackward,
  MoveHandLeft,
  MoveHandRight,
  RotateHand,
  GoTo,
  TurnTo,
  PickUp,
  PlaceOn,
  PlaceIn,
  Drop,
  Open,
  Close,
  TurnOn,
  TurnOff,
  Slice,
  PourTo,
  UseUp,
  Wipe,
  SpreadTo,
  SoakWith,
  HeatWith,
  CoolWith,
  WashWith,
  CookWith,
  BurnWith,
  FillWith,
  Stop,
  SitOn,
  LieOn,
  StandUp,
  PlugIn,
  Unplug,
  Fold,
  Break,
};
inline constexpr std::size_t kActionCount = static_cast<std::size_t>(ActionType::Break) + 1;

enum class ActionArgument : std::uint8_t { None, Object, ObjectOrRoom, Tool };
enum class ActionClass : std::uint8_t { Movement, Reach, Manipulation, Composite, Control };
enum class Mode : std::uint8_t { M1, M2, M3 };
inline constexpr std::array kModes{Mode::M1, Mode::M2, Mode::M3};
std::string_view name_of(Mode mode);  // "M1"
std::optional<Mode> mode_named(std::string_view name);
/// Which catalogue agents act by: the 38, or `wide`, in which the seven extension actions take the places of the seven
/// small moves of head and hand.
enum class ActionProfile : std::uint8_t { Unietp, Wide };
std::string_view name_of(ActionProfile profile);  // "unietp"
std::optional<ActionProfile> action_profile_named(std::string_view name);

enum class Failure : std::uint8_t;

struct ActionInfo {
  ActionType type;
  std::string_view name;  // "pick_up"
  ActionArgument argument;
  ActionClass group;
  bool m1, m2, m3;                               // the mode offers it
  bool ai2thor, virtualhome, habitat, behavior;  // the simulator has it
  std::string_view effect;                       // one line for people
  std::span<const Failure> failures;             // for each need that is not met, in order of checking; all actions
                                                 // can also be not_offered, or be given an invalid_argument
};
const ActionInfo& info(ActionType type);
std::optional<ActionType> action_named(std::string_view name);
/// The 38, and the seven of `wide`.
std::span<const ActionInfo> all_actions();
std::span<const ActionInfo> extension_actions();
bool offers(const ActionInfo& action, Simulator simulator);
bool offers(const ActionInfo& action, Mode mode);

/// Actions that an agent is offered, by type.
using ActionSet = std::bitset<kActionCount>;
/// What a simulator offers in a profile.
ActionSet actions_of(Simulator simulator, ActionProfile profile = ActionProfile::Unietp);

/// One step of an agent: `{"action": "place_in", "args": ["sink_1"]}`.
struct Action {
  ActionType type = ActionType::Stop;
  std::vector<std::string> args;  // ids of objects or rooms
  bool operator==(const Action&) const = default;
};
std::string to_text(const Action& action);  // "place_in(sink_1)"

/// Why an action failed; each kind has its own sentence for the agent.
enum class Failure : std::uint8_t {
  None,
  InvalidAction,
  InvalidArgument,
  NotOffered,
  Blocked,
  NoStandingPlace,
  TooFar,
  NotVisible,
  InsideClosed,
  ReceptacleClosed,
  NotAReceptacle,
  NoFreePlace,
  DidNotRest,
  DoesNotFit,
  NotPickupable,
  TooHeavy,
  NotOpenable,
  AlreadyOpen,
  AlreadyClosed,
  NotSwitchable,
  AlreadyOn,
  AlreadyOff,
  MustBeClosed,
  NotHolding,
  HandsFull,
  NotSliceable,
  NoKnife,
  NoEffect,
  VesselEmpty,
  NotFillable,
  AlreadyFull,
  NotConsumable,
  NotReady,
  NotASeat,
  Seated,
  NotSeated,
  NotPluggable,
  AlreadyPluggedIn,
  AlreadyUnplugged,
  NotPluggedIn,
  NotFoldable,
  AlreadyFolded,
  NotBreakable,
  AlreadyBroken,
  NotInView,  // the rules of a mode refuse it; the world was not asked
  NotSeenYet,
  NoObjectThere,
};
inline constexpr std::size_t kFailureCount = static_cast<std::size_t>(Failure::NoObjectThere) + 1;
std::string_view name_of(Failure failure);  // "too_far"
std::optional<Failure> failure_named(std::string_view name);

}  // namespace unietp
