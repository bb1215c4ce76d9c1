#include "scene/action_table.h"

namespace unietp {
namespace {

using enum ActionType;
using enum ActionArgument;
using enum ActionClass;
using C = FailureCause;
using F = Failure;
using P = Predicate;
using NeedKind = ActionNeed::Kind;

constexpr ActionNeed need(NeedKind kind, F failure) { return {kind, failure, {}, {}, {}}; }
constexpr ActionNeed has(std::string_view affordance, F failure, ActionRule rule = ActionRule::Always) {
  return {NeedKind::Affordance, failure, {}, affordance, rule};
}
constexpr ActionNeed varies(P state, F failure) { return {NeedKind::Varies, failure, state, {}, {}}; }
constexpr ActionNeed is(P state, F failure) { return {NeedKind::Is, failure, state, {}, {}}; }
constexpr ActionNeed is_not(P state, F failure, ActionRule rule = ActionRule::Always) {
  return {NeedKind::IsNot, failure, state, {}, rule};
}
constexpr ActionNeed held_is(P state, F failure) { return {NeedKind::HeldIs, failure, state, {}, {}}; }
constexpr ActionNeed held_is_not(P state, F failure, ActionRule rule) {
  return {NeedKind::HeldIsNot, failure, state, {}, rule};
}
constexpr ActionNeed fits(P relation) { return {NeedKind::Fits, F::DoesNotFit, relation, {}, {}}; }
constexpr ActionNeed special(F failure) { return need(NeedKind::Special, failure); }

// Needs that many actions share.
constexpr ActionNeed kReach = need(NeedKind::Reach, F::TooFar);
constexpr ActionNeed kReachOrInHand = need(NeedKind::ReachOrInHand, F::TooFar);
constexpr ActionNeed kPutDown = need(NeedKind::NotInHand, F::InvalidArgument);
constexpr ActionNeed kNotCarried = need(NeedKind::NotCarried, F::InvalidArgument);
constexpr ActionNeed kHolding = need(NeedKind::Holding, F::NotHolding);
constexpr ActionNeed kHandFree = need(NeedKind::HandFree, F::HandsFull);
constexpr ActionNeed kStandingUp = need(NeedKind::Standing, F::Seated);
constexpr ActionNeed kTargetTool = need(NeedKind::TargetTool, F::NoEffect);

// Needs by action, in order of checking.
constexpr std::array<ActionNeed, 0> kNone{};
constexpr std::array kWalking{kStandingUp, special(F::Blocked)};
constexpr std::array kTurning{kStandingUp};
constexpr std::array kTilting{special(F::Blocked)};
constexpr std::array kHandMoving{kHolding, special(F::Blocked)};
constexpr std::array kGoing{kStandingUp, special(F::NoStandingPlace)};
constexpr std::array kFacing{need(NeedKind::Sight, F::NotVisible)};
constexpr std::array kPicking{kPutDown,
                              has("pickupable", F::NotPickupable),
                              need(NeedKind::NotSeat, F::Seated),
                              kHandFree,
                              kReach,
                              special(F::TooHeavy)};
constexpr std::array kPlacingOn{kHolding,
                                kNotCarried,
                                kReach,
                                special(F::NotAReceptacle),
                                fits(P::On),
                                special(F::NoFreePlace),
                                special(F::DidNotRest)};
constexpr std::array kPlacingIn{kHolding,
                                kNotCarried,
                                kReach,
                                is_not(P::Closed, F::ReceptacleClosed),
                                special(F::NotAReceptacle),
                                fits(P::Inside),
                                special(F::NoFreePlace),
                                special(F::DidNotRest)};
constexpr std::array kDropping{kHolding, special(F::Blocked), special(F::DidNotRest)};
constexpr std::array kOpening{has("openable", F::NotOpenable),
                              kPutDown,
                              kReach,
                              is_not(P::Open, F::AlreadyOpen),
                              is_not(P::PowerOn, F::AlreadyOn, ActionRule::OpenNeedsPowerOff),
                              special(F::Blocked)};
constexpr std::array kClosing{has("openable", F::NotOpenable), kPutDown, kReach, is(P::Open, F::AlreadyClosed),
                              special(F::Blocked)};
constexpr std::array kTurningOn{varies(P::PowerOn, F::NotSwitchable), kReachOrInHand, is_not(P::PowerOn, F::AlreadyOn),
                                is_not(P::Open, F::MustBeClosed, ActionRule::PowerNeedsClosed),
                                is_not(P::Unplugged, F::NotPluggedIn, ActionRule::PowerNeedsPlug)};
constexpr std::array kTurningOff{varies(P::PowerOff, F::NotSwitchable), kReachOrInHand,
                                 is_not(P::PowerOff, F::AlreadyOff)};
constexpr std::array kSlicing{kPutDown,
                              has("sliceable", F::NotSliceable),
                              need(NeedKind::Holding, F::NoKnife),
                              need(NeedKind::HeldTool, F::NoKnife),
                              is_not(P::Sliced, F::NotSliceable),
                              kReach};
constexpr std::array kPouring{kHolding,
                              held_is(P::Filled, F::VesselEmpty),
                              kPutDown,
                              kReach,
                              has("fillable", F::NotFillable, ActionRule::TargetFills),
                              is_not(P::Filled, F::AlreadyFull, ActionRule::TargetFills)};
constexpr std::array kUsingUp{has("consumable", F::NotConsumable), kReachOrInHand, is_not(P::UsedUp, F::NotConsumable)};
constexpr std::array kWiping{kHolding, kPutDown, need(NeedKind::HeldTool, F::NoEffect), kReach,
                             held_is_not(P::Dry, F::NotReady, ActionRule::TargetStained)};
constexpr std::array kSpreading{kHolding, kPutDown, need(NeedKind::HeldTool, F::NoEffect), kReach};
constexpr std::array kTreating{kHolding, kTargetTool, kReach, special(F::NoFreePlace)};
constexpr std::array kSitting{has("sittable", F::NotASeat), kStandingUp, kPutDown, kReach, special(F::NoFreePlace)};
constexpr std::array kLying{has("lieable", F::NotASeat), kStandingUp, kPutDown, kReach, special(F::NoFreePlace)};
constexpr std::array kStanding{need(NeedKind::Seated, F::NotSeated)};
constexpr std::array kPluggingIn{varies(P::PluggedIn, F::NotPluggable), kPutDown, kReach,
                                 is_not(P::PluggedIn, F::AlreadyPluggedIn)};
constexpr std::array kUnplugging{varies(P::PluggedIn, F::NotPluggable), kPutDown, kReach,
                                 is(P::PluggedIn, F::AlreadyUnplugged)};
constexpr std::array kFolding{
    has("foldable", F::NotFoldable),     is_not(P::Folded, F::AlreadyFolded), kHandFree, kPutDown, kReach,
    need(NeedKind::Unloaded, F::Blocked)};
constexpr std::array kUnfolding{
    has("foldable", F::NotFoldable),     is(P::Folded, F::AlreadyUnfolded), kHandFree, kPutDown, kReach,
    need(NeedKind::Unloaded, F::Blocked)};
constexpr std::array kBreaking{has("breakable", F::NotBreakable), is_not(P::Broken, F::AlreadyBroken), kPutDown,
                               kReach};
constexpr std::array kReading{has("readable", F::NotReadable), need(NeedKind::InHand, F::NotHolding)};

// Changes by action.
constexpr std::array<ActionChange, 0> kNothing{};
constexpr ActionChange becomes(P state, ActionRule rule = ActionRule::Always) {
  return {.state = state, .only_if = {}, .rule = rule};
}
constexpr ActionChange if_it_is(P before, P after) { return {.state = after, .only_if = before}; }
constexpr ActionChange held_becomes(P state) { return {.state = state, .only_if = {}, .of = ActionChange::Of::Held}; }
constexpr ActionChange no_longer(P state) { return {.state = state, .only_if = {}, .ends = true}; }
constexpr std::array kPicksUp{becomes(P::Held)};
constexpr std::array kPlacesOn{held_becomes(P::On)};
constexpr std::array kPlacesIn{held_becomes(P::Inside)};
constexpr std::array kDrops{held_becomes(P::OnFloor)};
constexpr std::array kOpens{becomes(P::Open)};
constexpr std::array kCloses{becomes(P::Closed)};
constexpr std::array kTurnsOn{becomes(P::PowerOn)};
constexpr std::array kTurnsOff{becomes(P::PowerOff)};
constexpr std::array kSlices{becomes(P::Sliced)};
constexpr std::array kPours{becomes(P::Filled, ActionRule::TargetFills), held_becomes(P::Empty)};
constexpr std::array kWipes{no_longer(P::Covered), if_it_is(P::Dirty, P::Clean)};
constexpr std::array kSpreads{becomes(P::Covered)};
constexpr std::array kUsesUp{becomes(P::UsedUp)};
constexpr std::array kSits{becomes(P::SatOn)};
constexpr std::array kLies{becomes(P::LainOn)};
constexpr std::array kPlugsIn{becomes(P::PluggedIn)};
constexpr std::array kUnplugs{becomes(P::Unplugged), if_it_is(P::PowerOn, P::PowerOff)};
constexpr std::array kFolds{becomes(P::Folded)};
constexpr std::array kUnfolds{becomes(P::Unfolded)};
constexpr std::array kReads{becomes(P::Read)};
constexpr std::array kBreaks{becomes(P::Broken), if_it_is(P::Filled, P::Empty)};

constexpr ActionInfo row(ActionType type, std::string_view name, ActionArgument argument, ActionClass group,
                         std::string_view simulators, std::span<const ActionNeed> needs, std::string_view effect,
                         std::span<const ActionChange> changes = kNothing, bool starts_tool = false) {
  const auto in = [simulators](char letter) { return simulators.find(letter) != std::string_view::npos; };
  const bool atomic = group != ActionClass::Composite;  // composites are for planners on symbols: M1 only
  bool pictured = atomic;  // M3 names targets by boxes in the image, where the held object is not visible
  for (const ActionNeed& one : needs) pictured = pictured && one.kind != NeedKind::InHand;
  bool direct = !changes.empty();
  for (const ActionNeed& one : needs) direct = direct && one.kind != NeedKind::Holding;
  for (const ActionChange& one : changes) direct = direct && one.state != P::Held;
  return {type,    name,    argument, group,  true,  atomic,  pictured,    in('A'),
          in('V'), in('H'), in('B'),  effect, needs, changes, starts_tool, direct};
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
    row(TurnBaseToLook, "turn_base_to_look", None, Movement, "H", kNone, "the body turns to where the head looks"),
    row(ResetHead, "reset_head", None, Movement, "H", kNone, "the head looks straight ahead again"),
    row(MoveHandForward, "move_hand_forward", None, Movement, "A", kHandMoving,
        "the held object moves away from the body"),
    row(MoveHandBackward, "move_hand_backward", None, Movement, "A", kHandMoving,
        "the held object moves toward the body"),
    row(MoveHandLeft, "move_hand_left", None, Movement, "A", kHandMoving, "the held object moves left"),
    row(MoveHandRight, "move_hand_right", None, Movement, "A", kHandMoving, "the held object moves right"),
    row(RotateHand, "rotate_hand", None, Movement, "A", kHandMoving, "the held object turns in the hand"),
    row(GoTo, "go_to", ObjectOrRoom, Reach, "AVHB", kGoing, "the agent stands by the object, or in the room"),
    row(TurnTo, "turn_to", Object, Reach, "AVHB", kFacing, "the agent faces the object and looks at it"),
    row(PickUp, "pick_up", Object, Manipulation, "AVHB", kPicking, "the object is held and lies nowhere any more",
        kPicksUp),
    row(PlaceOn, "place_on", Object, Manipulation, "AVHB", kPlacingOn, "the held object is let down on the object",
        kPlacesOn, true),
    row(PlaceIn, "place_in", Object, Manipulation, "AVHB", kPlacingIn, "the held object is let down inside the object",
        kPlacesIn, true),
    row(Drop, "drop", None, Manipulation, "AHB", kDropping, "the held object falls to the floor", kDrops),
    row(Open, "open", Object, Manipulation, "AVHB", kOpening, "the object is open", kOpens, true),
    row(Close, "close", Object, Manipulation, "AVHB", kClosing, "the object is closed", kCloses, true),
    row(TurnOn, "turn_on", Object, Manipulation, "AVB", kTurningOn,
        "the object is on; a tap washes and fills what is under it", kTurnsOn, true),
    row(TurnOff, "turn_off", Object, Manipulation, "AVB", kTurningOff, "the object is off", kTurnsOff, true),
    row(Slice, "slice", Object, Manipulation, "AB", kSlicing,
        "the object is sliced and its slices exist; needs a held knife", kSlices),
    row(PourTo, "pour_to", Object, Manipulation, "AB", kPouring,
        "the held vessel is empty and the object filled; a drain stays empty", kPours),
    row(UseUp, "use_up", Object, Manipulation, "A", kUsingUp, "the object is used up", kUsesUp),
    row(Wipe, "wipe", Object, Manipulation, "B", kWiping,
        "the object is clean and uncovered; needs a held cloth, soaked for stains", kWipes),
    row(SpreadTo, "spread_to", Object, Manipulation, "B", kSpreading,
        "the object is covered with what the held dispenser gives", kSpreads),
    row(SoakWith, "soak_with", Tool, Manipulation, "B", kTreating, "the held object is soaked"),
    row(HeatWith, "heat_with", Tool, Composite, "A", kTreating, "the held object is hot"),
    row(CoolWith, "cool_with", Tool, Composite, "AB", kTreating, "the held object is cool; in a freezer it is frozen"),
    row(WashWith, "wash_with", Tool, Composite, "AB", kTreating,
        "the held object is clean; a tap leaves a vessel filled with water"),
    row(CookWith, "cook_with", Tool, Composite, "AB", kTreating, "the held object is cooked and hot"),
    row(BurnWith, "burn_with", Tool, Composite, "B", kTreating, "the held object is burnt"),
    row(FillWith, "fill_with", Tool, Composite, "AB", kTreating, "the held object is filled with what the tool gives"),
    row(Stop, "stop", None, Control, "AVHB", kNone, "the episode ends"),
    row(SitOn, "sit_on", Object, Manipulation, "V", kSitting, "the agent sits on the object", kSits),
    row(LieOn, "lie_on", Object, Manipulation, "V", kLying, "the agent lies on the object", kLies),
    row(StandUp, "stand_up", None, Movement, "V", kStanding, "the agent stands beside what it sat or lay on"),
    row(PlugIn, "plug_in", Object, Manipulation, "V", kPluggingIn, "the object is plugged in", kPlugsIn),
    row(Unplug, "unplug", Object, Manipulation, "V", kUnplugging, "the object is unplugged, and off", kUnplugs),
    row(Fold, "fold", Object, Manipulation, "B", kFolding, "the object is folded", kFolds),
    row(Break, "break", Object, Manipulation, "A", kBreaking, "the object is broken; what filled it is gone", kBreaks),
    row(Read, "read", Object, Manipulation, "V", kReading, "the agent has read the object, which it holds", kReads),
    row(Unfold, "unfold", Object, Manipulation, "B", kUnfolding, "the object is spread out, not folded", kUnfolds),
};

constexpr bool in_enum_order() {
  for (std::size_t i = 0; i < kActions.size(); ++i) {
    if (static_cast<std::size_t>(kActions[i].type) != i) return false;
  }
  return true;
}
static_assert(in_enum_order());

constexpr std::array<FailureInfo, kFailureCount> kFailures{{
    {F::None, "none", ""},
    {F::InvalidAction, "invalid_action", ""},
    {F::InvalidArgument, "invalid_argument", ""},
    {F::NotOffered, "not_offered", ""},
    {F::Blocked, "blocked", "free floor"},
    {F::NoStandingPlace, "no_standing_place", "a place to stand there"},
    {F::TooFar, "too_far", "it in reach ({reach_m} m)"},
    {F::NotVisible, "not_visible", "it in sight"},
    {F::InsideClosed, "inside_closed", "nothing closed around it"},
    {F::ReceptacleClosed, "receptacle_closed", "it open"},
    {F::NotAReceptacle, "not_a_receptacle", "something that holds things"},
    {F::NoFreePlace, "no_free_place", "a free place there"},
    {F::DidNotRest, "did_not_rest", ""},
    {F::DoesNotFit, "does_not_fit", "what you hold to fit"},
    {F::NotPickupable, "not_pickupable", "something that can be picked up"},
    {F::TooHeavy, "too_heavy", "at most {mass_kg} kg"},
    {F::NotOpenable, "not_openable", "something with a door, drawer or lid"},
    {F::AlreadyOpen, "already_open", "it closed"},
    {F::AlreadyClosed, "already_closed", "it open"},
    {F::NotSwitchable, "not_switchable", "something with a switch"},
    {F::AlreadyOn, "already_on", "it off"},
    {F::AlreadyOff, "already_off", "it on"},
    {F::MustBeClosed, "must_be_closed", "its door shut"},
    {F::NotHolding, "not_holding", "something in your hand"},
    {F::HandsFull, "hands_full", "a free hand"},
    {F::NotSliceable, "not_sliceable", "something that can be cut"},
    {F::NoKnife, "no_knife", "a knife in your hand"},
    {F::NoEffect, "no_effect", "things that go together"},
    {F::VesselEmpty, "vessel_empty", "something in the vessel that you hold"},
    {F::NotFillable, "not_fillable", "something that holds liquids"},
    {F::AlreadyFull, "already_full", "it empty"},
    {F::NotConsumable, "not_consumable", "something that is used up"},
    {F::NotReady, "not_ready", ""},
    {F::NotASeat, "not_a_seat", "a seat"},
    {F::Seated, "seated", ""},
    {F::NotSeated, "not_seated", ""},
    {F::NotPluggable, "not_pluggable", "something with a plug"},
    {F::AlreadyPluggedIn, "already_plugged_in", ""},
    {F::AlreadyUnplugged, "already_unplugged", ""},
    {F::NotPluggedIn, "not_plugged_in", ""},
    {F::NotFoldable, "not_foldable", "something that can be folded"},
    {F::AlreadyFolded, "already_folded", ""},
    {F::AlreadyUnfolded, "already_unfolded", "it folded"},
    {F::NotBreakable, "not_breakable", "something that breaks"},
    {F::AlreadyBroken, "already_broken", ""},
    {F::NotReadable, "not_readable", ""},
    {F::NotInView, "not_in_view", ""},
    {F::NotSeenYet, "not_seen_yet", ""},
    {F::NoObjectThere, "no_object_there", ""},
}};

constexpr bool failures_in_enum_order() {
  for (std::size_t i = 0; i < kFailures.size(); ++i) {
    if (static_cast<std::size_t>(kFailures[i].failure) != i) return false;
  }
  return true;
}
static_assert(failures_in_enum_order());

constexpr std::array<FailureCauseInfo, kFailureCauseCount> kCauses{{
    {C::None, F::None, ""},
    {C::EpisodeEnded, F::InvalidAction, "The episode has ended."},
    {C::MalformedAnswer, F::InvalidAction, "Your answer names no action: {object}."},
    {C::UnknownAction, F::InvalidAction, "There is no action {object}."},
    {C::ActionNotOffered, F::NotOffered, "{object} does not offer {other}."},
    {C::TakesNoArgument, F::InvalidArgument, "The action {object} takes no argument."},
    {C::TakesOneArgument, F::InvalidArgument, "The action {object} takes one argument."},
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
    {C::AlreadyUnfolded, F::AlreadyUnfolded, "{object} is not folded."},
    {C::MustBePutDownToFold, F::HandsFull, "Put {object} down to fold or unfold it."},
    {C::FoldingTakesFreeHand, F::HandsFull, "Folding and unfolding take a free hand."},
    {C::SomethingLiesOn, F::Blocked, "{object} lies on {other}."},
    {C::NotBreakable, F::NotBreakable, "{object} cannot be broken."},
    {C::AlreadyBroken, F::AlreadyBroken, "{object} is broken already."},
    {C::NotReadable, F::NotReadable, "{object} cannot be read."},
    {C::MustBeHeldToRead, F::NotHolding, "Pick {object} up to read it."},
}};

constexpr bool causes_in_enum_order() {
  for (std::size_t i = 0; i < kCauses.size(); ++i) {
    if (static_cast<std::size_t>(kCauses[i].cause) != i) return false;
  }
  return true;
}
static_assert(causes_in_enum_order(), "a cause has no row");

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

std::span<const ActionInfo, kActionCount> action_table() { return kActions; }

std::span<const FailureInfo, kFailureCount> failure_table() { return kFailures; }

const FailureCauseInfo& info(FailureCause cause) { return kCauses[static_cast<std::size_t>(cause)]; }

}  // namespace unietp
