#include <algorithm>
#include <cmath>

#include "simulation/world_state.h"

// Actions of the profile `wide` only: sitting, lying, plugs, folding and breaking.
namespace unietp {
namespace {

constexpr double kSpotPitch_m = 0.05;
constexpr double kAboveSeat_m = 0.01;
// Free space that a body needs on a seat and on a bed: width, depth and height. Curated.
const Vec3 kSitter_m(0.3, 0.3, 0.5);
const Vec3 kLier_m(1.4, 0.4, 0.3);

std::optional<std::size_t> seat_of(const WorldState& state) {
  for (std::size_t i = 0; i < state.count(); ++i) {
    const StateSet& states = state.node(i).states;
    if (states.has(Predicate::SatOn) || states.has(Predicate::LainOn)) return i;
  }
  return std::nullopt;
}

ActionResult is_seated(const WorldState& state, std::size_t seat) {
  const bool lies = state.node(seat).states.has(Predicate::LainOn);
  return failed(lies ? FailureCause::LiesOn : FailureCause::SitsOn, state.reference(seat));
}

/// Whether no movable object other than the seat is in the body's space. Furniture is ignored, since a chair can be
/// pulled out from under a table.
bool free_for_body(const WorldState& state, std::size_t seat, const Pose& pose, const Vec3& size) {
  Shape body;
  body.parts.push_back({Part::Kind::Box, {}, size, -1});
  std::vector<BodyId> ignore{BodyId::node(seat)};
  for (const BodyId id : state.physics().near(bounds_of(pose, size), 0)) {
    if (!id.is_node() || !state.node(id.index()).movable) ignore.push_back(id);
  }
  return !state.physics().overlap(body, pose, 0, ignore);
}

bool has_place_for(const WorldState& state, std::size_t seat, const Vec3& body) {
  const Node& node = state.node(seat);
  const Shape& shape = state.collider(seat).shape;
  for (const Surface& surface : shape.surfaces) {
    const Pose frame = node.pose * joint_motion(shape, surface.joint, node.opening);
    for (const bool across : {false, true}) {
      Vec3 size = across ? Vec3(body.y(), body.x(), body.z()) : body;
      size.head<2>() = size.head<2>().cwiseMin(2 * surface.half);  // a seat may be narrower than the body
      const Vec2 room = surface.half - size.head<2>() / 2;
      const int nx = static_cast<int>(room.x() / kSpotPitch_m), ny = static_cast<int>(room.y() / kSpotPitch_m);
      for (int x = -nx; x <= nx; ++x) {
        for (int y = -ny; y <= ny; ++y) {
          const Vec3 up(x * kSpotPitch_m, y * kSpotPitch_m, size.z() / 2 + kAboveSeat_m);
          if (free_for_body(state, seat, frame * Pose{surface.center + up, Quat::Identity()}, size)) return true;
        }
      }
    }
  }
  return false;
}

/// Why the agent cannot act on a node by hand, or nullopt; held objects count as a failure.
std::optional<ActionResult> manual_access_failure(const WorldState& state, std::size_t i) {
  if (state.held(state.node(i).id)) return failed(FailureCause::MustBePutDown, state.reference(i));
  return access_failure(state, i);
}

void turn_to_work(WorldState& state, std::size_t i) {
  look_at(state, state.node(i).pose.position);
  state.carry_along();
}

ActionResult take_seat(WorldState& state, std::size_t i, Predicate as) {
  const bool lies = as == Predicate::LainOn;
  if (!state.knowledge->has(state.node(i).category, lies ? "lieable" : "sittable"))
    return failed(lies ? FailureCause::CannotLieOn : FailureCause::CannotSitOn, state.reference(i));
  if (const auto seat = seat_of(state)) return is_seated(state, *seat);
  if (auto blocked = manual_access_failure(state, i)) return *blocked;
  if (!has_place_for(state, i, lies ? kLier_m : kSitter_m)) return failed(FailureCause::SeatTaken, state.reference(i));
  state.edit_states(i).set({as, ""});
  const Vec3 front = state.node(i).pose.rotation * -Vec3::UnitY();
  if (front.head<2>().norm() > 1e-9) state.edit_agent().yaw = std::atan2(front.y(), front.x());
  state.edit_agent().pitch = 0;
  state.carry_along();
  return succeeded();
}

ActionResult plug(WorldState& state, std::size_t i, bool in) {
  const bool plugged = state.node(i).states.has(Predicate::PluggedIn);
  if (!plugged && !state.node(i).states.has(Predicate::Unplugged))
    return failed(FailureCause::NoPlug, state.reference(i));
  if (auto blocked = manual_access_failure(state, i)) return *blocked;
  if (in && plugged) return failed(FailureCause::AlreadyPluggedIn, state.reference(i));
  if (!in && !plugged) return failed(FailureCause::AlreadyUnplugged, state.reference(i));
  state.edit_states(i).set({in ? Predicate::PluggedIn : Predicate::Unplugged, ""});
  if (!in && state.node(i).states.has(Predicate::PowerOn)) state.edit_states(i).set({Predicate::PowerOff, ""});
  turn_to_work(state, i);
  return succeeded();
}

ActionResult fold(WorldState& state, std::size_t i, bool up) {
  if (!state.knowledge->has(state.node(i).category, "foldable"))
    return failed(FailureCause::NotFoldable, state.reference(i));
  if (state.node(i).states.has(Predicate::Folded) == up)
    return failed(up ? FailureCause::AlreadyFolded : FailureCause::AlreadyUnfolded, state.reference(i));
  if (static_cast<int>(state.agent().held.size()) >= state.profile->hands) {
    if (state.held(state.node(i).id)) return failed(FailureCause::MustBePutDownToFold, state.reference(i));
    return failed(FailureCause::FoldingTakesFreeHand);
  }
  if (auto blocked = manual_access_failure(state, i)) return *blocked;
  if (const auto group = state.group_of(i); group.size() > 1)
    return failed(FailureCause::SomethingLiesOn, state.reference(group[1]), state.reference(i));
  state.edit_states(i).set({up ? Predicate::Folded : Predicate::Unfolded, ""});
  turn_to_work(state, i);
  return succeeded();
}

ActionResult break_apart(WorldState& state, std::size_t i) {
  if (!state.knowledge->has(state.node(i).category, "breakable"))
    return failed(FailureCause::NotBreakable, state.reference(i));
  if (state.node(i).states.has(Predicate::Broken)) return failed(FailureCause::AlreadyBroken, state.reference(i));
  if (auto blocked = manual_access_failure(state, i)) return *blocked;
  state.edit_states(i).set({Predicate::Broken, ""});
  if (state.node(i).states.has(Predicate::Filled)) state.edit_states(i).set({Predicate::Empty, ""});
  turn_to_work(state, i);
  return succeeded();
}

ActionResult read(WorldState& state, std::size_t i) {
  if (!state.knowledge->has(state.node(i).category, "readable"))
    return failed(FailureCause::NotReadable, state.reference(i));
  if (!state.held(state.node(i).id)) return failed(FailureCause::MustBeHeldToRead, state.reference(i));
  state.edit_states(i).set({Predicate::Read, ""});
  return succeeded();
}

}  // namespace

std::optional<ActionResult> seated_failure(const WorldState& state, ActionType type) {
  if (!state.profile->offers(ActionType::SitOn) && !state.profile->offers(ActionType::LieOn)) return std::nullopt;
  if (type == ActionType::StandUp || type == ActionType::LookUp || type == ActionType::LookDown) return std::nullopt;
  const auto seat = seat_of(state);
  return seat ? std::optional(is_seated(state, *seat)) : std::nullopt;
}

ActionResult stand_up(WorldState& state) {
  const auto seat = seat_of(state);
  if (!seat) return failed(FailureCause::NotSeated);
  state.edit_states(*seat).clear(Predicate::SatOn);
  state.edit_states(*seat).clear(Predicate::LainOn);
  return succeeded();
}

ActionResult perform_extension(WorldState& state, ActionType type, std::size_t node) {
  switch (type) {
    case ActionType::SitOn:
      return take_seat(state, node, Predicate::SatOn);
    case ActionType::LieOn:
      return take_seat(state, node, Predicate::LainOn);
    case ActionType::PlugIn:
      return plug(state, node, true);
    case ActionType::Unplug:
      return plug(state, node, false);
    case ActionType::Fold:
      return fold(state, node, true);
    case ActionType::Unfold:
      return fold(state, node, false);
    case ActionType::Break:
      return break_apart(state, node);
    case ActionType::Read:
      return read(state, node);
    default:
      return failed(FailureCause::TakesNoArgument, in_words(info(type).name));
  }
}

}  // namespace unietp
