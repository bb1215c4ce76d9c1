#include "simulation/world_state.h"

namespace unietp {
namespace {

ActionResult wrong_arguments(const ActionInfo& action) {
  const bool none = action.argument == ActionArgument::None;
  return failed(none ? FailureCause::TakesNoArgument : FailureCause::TakesOneArgument, in_words(action.name));
}

/// Actions without an argument.
ActionResult perform_alone(WorldState& state, ActionType type) {
  switch (type) {
    case ActionType::MoveForward:
    case ActionType::MoveBackward:
    case ActionType::MoveLeft:
    case ActionType::MoveRight:
    case ActionType::TurnLeft:
    case ActionType::TurnRight:
    case ActionType::LookUp:
    case ActionType::LookDown:
      return move_body(state, type);
    case ActionType::TurnBaseToLook:
      return succeeded();  // the head does not turn independently of the base
    case ActionType::ResetHead:
      return reset_head(state);
    case ActionType::MoveHandForward:
      return move_hand(state, 1, 0);
    case ActionType::MoveHandBackward:
      return move_hand(state, -1, 0);
    case ActionType::MoveHandLeft:
      return move_hand(state, 0, 1);
    case ActionType::MoveHandRight:
      return move_hand(state, 0, -1);
    case ActionType::RotateHand:
      return rotate_hand(state);
    case ActionType::Drop:
      return drop(state);
    case ActionType::StandUp:
      return stand_up(state);
    default:
      return failed(FailureCause::TakesOneArgument, in_words(info(type).name));
  }
}

/// A freezer may have the effect `freezes` without `cools`.
ActionResult cool_with(WorldState& state, std::size_t tool, const PassesThrough& passes) {
  const std::size_t before = state.mark();
  ActionResult cooled = treat_with(state, tool, Treatment::Cools, passes);
  if (cooled.failure != Failure::NoEffect) return cooled;
  state.back_to(before);
  return treat_with(state, tool, Treatment::Freezes, passes);
}

}  // namespace

ActionResult perform(WorldState& state, const Action& action, const PassesThrough& passes) {
  if (state.stopped()) return failed(FailureCause::EpisodeEnded);
  const ActionInfo& about = info(action.type);
  if (!state.profile->offers(action.type)) {
    return failed(FailureCause::ActionNotOffered, in_words(name_of(state.scene().simulator)), in_words(about.name));
  }
  if (action.args.size() != (about.argument == ActionArgument::None ? 0u : 1u)) return wrong_arguments(about);
  if (action.type == ActionType::Stop) {
    state.stop();
    return succeeded();
  }
  if (about.group == ActionClass::Movement || action.type == ActionType::GoTo) {
    if (auto seated = seated_failure(state, action.type)) return *seated;
  }
  if (action.type == ActionType::GoTo) return go_to(state, action.args.front());
  if (about.argument == ActionArgument::None) return perform_alone(state, action.type);
  const auto node = state.index_of(action.args.front());
  if (!node) return failed(FailureCause::NoSuchObject, unknown_name(action.args.front()));
  switch (action.type) {
    case ActionType::TurnTo:
      return turn_to(state, *node);
    case ActionType::PickUp:
      return pick_up(state, *node);
    case ActionType::PlaceOn:
      return place(state, *node, false);
    case ActionType::PlaceIn:
      return place(state, *node, true);
    case ActionType::Open:
      return swing(state, *node, true);
    case ActionType::Close:
      return swing(state, *node, false);
    case ActionType::TurnOn:
      return switch_power(state, *node, true);
    case ActionType::TurnOff:
      return switch_power(state, *node, false);
    case ActionType::Slice:
      return slice(state, *node);
    case ActionType::PourTo:
      return pour_to(state, *node);
    case ActionType::UseUp:
      return use_up(state, *node);
    case ActionType::Wipe:
      return wipe(state, *node);
    case ActionType::SpreadTo:
      return spread_to(state, *node);
    case ActionType::SoakWith:
      return treat_with(state, *node, Treatment::Soaks, passes);
    case ActionType::HeatWith:
      return treat_with(state, *node, Treatment::Heats, passes);
    case ActionType::CoolWith:
      return cool_with(state, *node, passes);
    case ActionType::WashWith:
      return treat_with(state, *node, Treatment::Washes, passes);
    case ActionType::CookWith:
      return treat_with(state, *node, Treatment::Cooks, passes);
    case ActionType::BurnWith:
      return treat_with(state, *node, Treatment::Burns, passes);
    case ActionType::FillWith:
      return treat_with(state, *node, Treatment::Fills, passes);
    default:
      return perform_extension(state, action.type, *node);
  }
}

}  // namespace unietp
