#pragma once

#include <cstdint>
#include <string_view>

#include "scene/action.h"

namespace unietp {

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
