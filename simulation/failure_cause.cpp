#include "simulation/failure_cause.h"

#include <array>

namespace unietp {
namespace {

using C = FailureCause;
using F = Failure;

constexpr std::array<FailureCauseInfo, kFailureCauseCount> kCauses{{
    {C::None, F::None, ""},
    {C::EpisodeEnded, F::InvalidAction, "The episode has ended."},
    {C::MalformedAnswer, F::InvalidAction, "Your answer names no action: {object}."},
    {C::UnknownAction, F::InvalidAction, "There is no action {object}."},
    {C::ActionNotOffered, F::NotOffered, "{object} does not offer {other}."},
    {C::TakesNoArgument, F::InvalidArgument, "{object} takes no argument."},
    {C::TakesOneArgument, F::InvalidArgument, "{object} takes one argument."},
    {C::NoSuchObject, F::InvalidArgument, "There is no object {object}."},
    {C::NoSuchObjectOrRoom, F::InvalidArgument, "There is no object or room {object}."},
    {C::NamedByBox, F::InvalidArgument, "In {object} objects are named by id, not by a box."},
    {C::NamedById, F::InvalidArgument, "In {object} objects are named by boxes in the picture."},
    {C::NotInView, F::NotInView, "That is not in view; go to a room, to furniture, or to what you see."},
    {C::NotSeenYet, F::NotSeenYet, "You have not seen that yet."},
    {C::NoTeleport, F::NotOffered, "You cannot go into a room in one step; walk there."},
    {C::NoObjectAtBox, F::NoObjectThere, "There is no object at the given box."},
    {C::SitsOn, F::Seated, "You sit on {object}; stand up first."},
    {C::LiesOn, F::Seated, "You lie on {object}; stand up first."},
    {C::NotSeated, F::NotSeated, "You stand already."},
    {C::BodyBlocked, F::Blocked, "Something is in the way of your body."},
    {C::CameraAtHighest, F::Blocked, "You cannot look further up."},
    {C::CameraAtLowest, F::Blocked, "You cannot look further down."},
    {C::ArmAtLimit, F::Blocked, "Your arm does not reach further that way."},
    {C::HeldWouldHit, F::Blocked, "{object} would hit {other}."},
    {C::RoomUnreachable, F::NoStandingPlace, "There is no way to walk into {object}."},
    {C::NoPlaceToStand, F::NoStandingPlace, "There is no place to stand from which to reach {object}."},
    {C::InsideClosed, F::InsideClosed, "{object} is inside {other}, which is closed."},
    {C::OutOfReach, F::TooFar, "{object} is out of reach; go to it first."},
    {C::OutOfSight, F::NotVisible, "{object} is not in sight from here."},
    {C::InHand, F::InvalidArgument, "{object} is in your hand."},
    {C::AlreadyInHand, F::InvalidArgument, "{object} is already in your hand."},
    {C::MustBePutDown, F::InvalidArgument, "{object} is in your hand; put it down first."},
    {C::HandsEmpty, F::NotHolding, "Your hands are empty."},
    {C::HandsFull, F::HandsFull, "You already hold {object}."},
    {C::NotPickupable, F::NotPickupable, "{object} cannot be picked up."},
    {C::TooHeavy, F::TooHeavy, "{object} is too heavy."},
    {C::ReceptacleClosed, F::ReceptacleClosed, "{object} is closed."},
    {C::NoInside, F::NotAReceptacle, "Nothing can be put inside {object}."},
    {C::NoSurface, F::NotAReceptacle, "Nothing can be put on {object}."},
    {C::DoesNotFitInto, F::DoesNotFit, "{object} does not fit into {other}."},
    {C::DoesNotFitOn, F::DoesNotFit, "{object} does not fit on {other}."},
    {C::NoFreePlaceInside, F::NoFreePlace, "There is no free place in reach inside {object}."},
    {C::NoFreePlaceOn, F::NoFreePlace, "There is no free place in reach on {object}."},
    {C::DidNotRest, F::DidNotRest, "{object} did not come to rest there."},
    {C::NoRoomToFall, F::Blocked, "There is no room to let {object} fall here."},
    {C::WouldNotRest, F::DidNotRest, "{object} would not come to rest here."},
    {C::NotOpenable, F::NotOpenable, "{object} cannot be opened or closed."},
    {C::AlreadyOpen, F::AlreadyOpen, "{object} is already open."},
    {C::AlreadyClosed, F::AlreadyClosed, "{object} is already closed."},
    {C::StillRunning, F::AlreadyOn, "{object} is running; turn it off first."},
    {C::JointBlocked, F::Blocked, "{object} is blocked by {other}."},
    {C::AgentInTheWay, F::Blocked, "You stand in the way of {object}."},
    {C::NotSwitchable, F::NotSwitchable, "{object} cannot be turned on or off."},
    {C::AlreadyOn, F::AlreadyOn, "{object} is already on."},
    {C::AlreadyOff, F::AlreadyOff, "{object} is already off."},
    {C::MustBeClosed, F::MustBeClosed, "{object} must be closed before it is turned on."},
    {C::NotPluggedIn, F::NotPluggedIn, "{object} is not plugged in."},
    {C::NoPlug, F::NotPluggable, "{object} has no plug."},
    {C::AlreadyPluggedIn, F::AlreadyPluggedIn, "{object} is already plugged in."},
    {C::AlreadyUnplugged, F::AlreadyUnplugged, "{object} is already unplugged."},
    {C::ToolHasNoEffect, F::NoEffect, "{object} cannot be treated so with {other}."},
    {C::NotSliceable, F::NotSliceable, "{object} cannot be sliced."},
    {C::AlreadySliced, F::NotSliceable, "{object} is already sliced."},
    {C::NeedsKnife, F::NoKnife, "You need something sharp in your hand."},
    {C::DoesNotSlice, F::NoKnife, "{object} does not slice {other}."},
    {C::VesselEmpty, F::VesselEmpty, "There is nothing in {object} to pour."},
    {C::NotFillable, F::NotFillable, "{object} cannot be filled."},
    {C::AlreadyFull, F::AlreadyFull, "{object} is full already."},
    {C::NotConsumable, F::NotConsumable, "{object} cannot be used up."},
    {C::AlreadyUsedUp, F::NotConsumable, "{object} is used up already."},
    {C::NeedsCloth, F::NotHolding, "You need something to wipe with in your hand."},
    {C::CannotBeWiped, F::NoEffect, "{object} cannot be wiped with {other}."},
    {C::ClothDry, F::NotReady, "{object} is dry; soak it first."},
    {C::NeedsDispenser, F::NotHolding, "You need something to spread in your hand."},
    {C::DispensesNothing, F::NoEffect, "Nothing comes out of {object} that covers {other}."},
    {C::CannotSitOn, F::NotASeat, "One cannot sit on {object}."},
    {C::CannotLieOn, F::NotASeat, "One cannot lie on {object}."},
    {C::SeatTaken, F::NoFreePlace, "There is no free place on {object}; something lies there."},
    {C::NotFoldable, F::NotFoldable, "{object} cannot be folded."},
    {C::AlreadyFolded, F::AlreadyFolded, "{object} is folded already."},
    {C::MustBePutDownToFold, F::HandsFull, "Put {object} down to fold it."},
    {C::FoldingTakesFreeHand, F::HandsFull, "Folding takes a free hand."},
    {C::SomethingLiesOn, F::Blocked, "{object} lies on {other}."},
    {C::NotBreakable, F::NotBreakable, "{object} cannot be broken."},
    {C::AlreadyBroken, F::AlreadyBroken, "{object} is broken already."},
    {C::NotReadable, F::NotReadable, "{object} cannot be read."},
    {C::MustBeHeldToRead, F::NotHolding, "Pick {object} up to read it."},
}};

constexpr bool rows_are_in_enum_order() {
  for (std::size_t i = 0; i < kCauses.size(); ++i) {
    if (static_cast<std::size_t>(kCauses[i].cause) != i) return false;
  }
  return true;
}
static_assert(rows_are_in_enum_order(), "a cause has no row");

constexpr bool every_cause_has_a_sentence() {
  for (const FailureCauseInfo& row : kCauses) {
    if (row.sentence.empty() != (row.cause == C::None) || (row.failure == F::None) != (row.cause == C::None))
      return false;
  }
  return true;
}
static_assert(every_cause_has_a_sentence());

constexpr bool every_failure_has_a_cause() {
  for (std::size_t failure = 0; failure < kFailureCount; ++failure) {
    bool found = false;
    for (const FailureCauseInfo& row : kCauses) found = found || static_cast<std::size_t>(row.failure) == failure;
    if (!found) return false;
  }
  return true;
}
static_assert(every_failure_has_a_cause(), "a kind of failure has no sentence");

}  // namespace

const FailureCauseInfo& info(FailureCause cause) { return kCauses[static_cast<std::size_t>(cause)]; }

}  // namespace unietp
