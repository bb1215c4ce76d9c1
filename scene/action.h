#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "logic/vocabulary.h"
#include "scene/simulator.h"

namespace unietp {

/// The 38 action types and those of the profile `wide`, numbered as in docs/actions.md.
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
  Read,
  Unfold,
};
/// Number of action types, those of `wide` included.
inline constexpr std::size_t kActionCount = static_cast<std::size_t>(ActionType::Unfold) + 1;

/// What an action's one argument names. A tool is an object that treats what the agent holds.
enum class ActionArgument : std::uint8_t { None, Object, ObjectOrRoom, Tool };
std::string_view name_of(ActionArgument argument);  // "object or room"
/// Movement: body, camera and hand in small steps. Reach: going and turning to an object. Manipulation: what the hand
/// does. Composite: several manipulations with an appliance, in M1 only. Control: `stop`.
enum class ActionClass : std::uint8_t { Movement, Reach, Manipulation, Composite, Control };
std::string_view name_of(ActionClass group);  // "manipulation"
/// How much an agent is told: all ids (M1), the ids of what it has seen (M2), pictures only (M3). See docs/modes.md.
enum class Mode : std::uint8_t { M1, M2, M3 };
inline constexpr std::array kModes{Mode::M1, Mode::M2, Mode::M3};
std::string_view name_of(Mode mode);  // "M1"
/// nullopt for an unknown name; likewise for the other `..._named` of this header.
std::optional<Mode> mode_named(std::string_view name);
/// Which actions agents are offered: the 38, or `wide`, in which the extension actions take the places of the seven
/// small moves of head and hand.
enum class ActionProfile : std::uint8_t { Unietp, Wide };
std::string_view name_of(ActionProfile profile);  // "unietp"
std::optional<ActionProfile> action_profile_named(std::string_view name);

enum class Failure : std::uint8_t;

/// When a need is checked or a change made: always, under a rule that only some simulators have, or by what the target
/// is.
enum class ActionRule : std::uint8_t {
  Always,
  OpenNeedsPowerOff,
  PowerNeedsClosed,
  PowerNeedsPlug,
  TargetFills,    // the target does not drain what is poured into it
  TargetStained,  // the target is dirty, or covered with something other than dust
};

/// One need of an action on a target. The needs of an action are checked in order; the first that is not met is why the
/// action fails.
struct ActionNeed {
  enum class Kind : std::uint8_t {
    Affordance,     // the target's category has `affordance`
    Varies,         // the target is in one of the states of the group of `state`
    Is,             // the target is `state`
    IsNot,          // the target is not `state`
    NotInHand,      // the hand does not hold the target
    NotCarried,     // nor what the target rests on or in
    InHand,         // the hand holds the target
    HandFree,       // the hand holds nothing
    Holding,        // the hand holds something
    HeldIs,         // what the hand holds is `state`
    HeldIsNot,      // what the hand holds is not `state`
    HeldTool,       // what the hand holds has an effect of this action on the target
    TargetTool,     // the target has an effect of this action on what the hand holds
    Fits,           // things like the one in the hand go on or inside (`state`) things like the target
    Reach,          // nothing closed is around the target, it is in reach and in sight
    ReachOrInHand,  // as Reach, or the hand holds the target
    Sight,          // the target is in sight
    Unloaded,       // nothing rests on or in the target
    Standing,       // the agent neither sits nor lies
    Seated,         // the agent sits or lies
    NotSeat,        // the agent neither sits nor lies on the target
    Special,        // checked in code: geometry, which only simulation/ has, and what no other kind says
  };
  Kind kind;
  Failure failure;
  Predicate state = Predicate::Open;
  std::string_view affordance;
  ActionRule rule = ActionRule::Always;
};

/// A state of the target or of what the hand holds begins, or where it is: held; on or inside the target; on_floor,
/// where the agent stands. Covered: with what the hand holds gives.
struct ActionChange {
  enum class Of : std::uint8_t { Target, Held };
  Predicate state;
  std::optional<Predicate> only_if;  // only of what was in that state
  Of of = Of::Target;
  bool ends = false;  // the state ends instead
  ActionRule rule = ActionRule::Always;
};

/// All that is known of one action type: a row of scene/action_table.cpp.
struct ActionInfo {
  ActionType type;
  std::string_view name;  // "pick_up"
  ActionArgument argument;
  ActionClass group;
  bool m1, m2, m3;                               // the mode offers it
  bool ai2thor, virtualhome, habitat, behavior;  // the simulator has it
  std::string_view effect;                       // one line for people
  std::span<const ActionNeed> needs;             // in order of checking
  std::span<const ActionChange> changes;         // the first is what the action is for
  bool starts_tool;  // afterwards the target treats what is on or in it (scene/treatment.h), if it is a tool that can
  bool direct;       // all changes are states of the target, and the hand needs nothing for them
};
/// The row of a type. Every type has one.
const ActionInfo& info(ActionType type);
std::optional<ActionType> action_named(std::string_view name);
/// A failure for each need that is not met, without repeats, in order of checking. All actions can also fail as
/// not_offered and invalid_argument.
std::vector<Failure> failures_of(const ActionInfo& action);
/// The direct action for a state; nullopt where there is none.
std::optional<ActionType> direct_action(Predicate state);
/// The affordance that a direct action needs: "openable". Empty for other actions.
std::string_view affordance_for(const ActionInfo& action);
/// Whether only the profile `wide` offers it.
bool is_extension(ActionType type);
/// The 38, and those that only `wide` offers.
std::span<const ActionInfo> all_actions();
std::span<const ActionInfo> extension_actions();
/// Whether the simulator, or the mode, has the action in any profile.
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

/// Why an action failed, as files record it.
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
  AlreadyUnfolded,
  NotBreakable,
  AlreadyBroken,
  NotReadable,
  NotInView,  // the rules of a mode refuse it; the world was not asked
  NotSeenYet,
  NoObjectThere,
};
/// Number of kinds of failure, None included.
inline constexpr std::size_t kFailureCount = static_cast<std::size_t>(Failure::NoObjectThere) + 1;

/// A row of the table of failures.
struct FailureInfo {
  Failure failure;
  std::string_view name;  // "too_far"
  // What is missing, as a noun phrase for planners: "a free hand". {reach_m} and {mass_kg} stand for limits of the
  // profile. "" for what an agent cannot look after.
  std::string_view need;
};
/// The row of a failure. Every failure has one.
const FailureInfo& info(Failure failure);
std::string_view name_of(Failure failure);
std::optional<Failure> failure_named(std::string_view name);

/// What exactly made an action fail: one entry for each sentence that an agent may be given. Several causes share a
/// `Failure`, which is what programs and files see.
enum class FailureCause : std::uint8_t {
  None,
  // the command itself
  EpisodeEnded,
  MalformedAnswer,
  UnknownAction,
  ActionNotOffered,
  TakesNoArgument,
  TakesOneArgument,
  NoSuchObject,
  NoSuchObjectOrRoom,
  NamedByBox,
  NamedById,
  NotInView,
  NotSeenYet,
  NoTeleport,
  NoObjectAtBox,
  // body, camera and arm
  SitsOn,
  LiesOn,
  NotSeated,
  BodyBlocked,
  CameraAtHighest,
  CameraAtLowest,
  ArmAtLimit,
  HeldWouldHit,
  RoomUnreachable,
  NoPlaceToStand,
  // what every action by hand needs
  InsideClosed,
  OutOfReach,
  OutOfSight,
  InHand,
  AlreadyInHand,
  MustBePutDown,
  HandsEmpty,
  HandsFull,
  // picking up and placing
  NotPickupable,
  TooHeavy,
  ReceptacleClosed,
  NoInside,
  NoSurface,
  DoesNotFitInto,
  DoesNotFitOn,
  NoFreePlaceInside,
  NoFreePlaceOn,
  DidNotRest,
  NoRoomToFall,
  WouldNotRest,
  // doors, power and plugs
  NotOpenable,
  AlreadyOpen,
  AlreadyClosed,
  StillRunning,
  JointBlocked,
  AgentInTheWay,
  NotSwitchable,
  AlreadyOn,
  AlreadyOff,
  MustBeClosed,
  NotPluggedIn,
  NoPlug,
  AlreadyPluggedIn,
  AlreadyUnplugged,
  // tools and contents
  ToolHasNoEffect,
  NotSliceable,
  AlreadySliced,
  NeedsKnife,
  DoesNotSlice,
  VesselEmpty,
  NotFillable,
  AlreadyFull,
  NotConsumable,
  AlreadyUsedUp,
  NeedsCloth,
  CannotBeWiped,
  ClothDry,
  NeedsDispenser,
  DispensesNothing,
  // seats, folding and breaking
  CannotSitOn,
  CannotLieOn,
  SeatTaken,
  NotFoldable,
  AlreadyFolded,
  AlreadyUnfolded,
  MustBePutDownToFold,
  FoldingTakesFreeHand,
  SomethingLiesOn,
  NotBreakable,
  AlreadyBroken,
  NotReadable,
  MustBeHeldToRead,
};
/// Number of causes, None included.
inline constexpr std::size_t kFailureCauseCount = static_cast<std::size_t>(FailureCause::MustBeHeldToRead) + 1;

/// One row of the table of causes.
struct FailureCauseInfo {
  FailureCause cause;
  Failure failure;            // the kind that files record
  std::string_view sentence;  // in English; {object} and {other} stand for what the failure refers to
};
/// The row of a cause.
const FailureCauseInfo& info(FailureCause cause);

}  // namespace unietp
