#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/simulator.h"

namespace unietp {

/// The 38 action types, numbered as in docs/actions.md.
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
};
inline constexpr std::size_t kActionCount = static_cast<std::size_t>(ActionType::Stop) + 1;

enum class ActionArgument : std::uint8_t { None, Object, ObjectOrRoom, Tool };
enum class ActionClass : std::uint8_t { Movement, Reach, Manipulation, Composite, Control };
enum class Mode : std::uint8_t { M1, M2, M3 };
std::string_view name_of(Mode mode);  // "M1"

struct ActionInfo {
  ActionType type;
  std::string_view name;  // "pick_up"
  ActionArgument argument;
  ActionClass group;
  bool m1, m2, m3;                               // the mode offers it
  bool ai2thor, virtualhome, habitat, behavior;  // the simulator offers it
  std::string_view effect;                       // one line for people
};
const ActionInfo& info(ActionType type);
std::optional<ActionType> action_named(std::string_view name);
std::span<const ActionInfo> all_actions();
bool offers(const ActionInfo& action, Simulator simulator);
bool offers(const ActionInfo& action, Mode mode);

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
};
std::string_view name_of(Failure failure);  // "too_far"
std::optional<Failure> failure_named(std::string_view name);

}  // namespace unietp
