// What scene/action.h reads off the table of actions.
#include <array>

#include "core/text.h"
#include "scene/action.h"
#include "scene/action_table.h"

namespace unietp {
namespace {

constexpr std::size_t kDefaultCount = static_cast<std::size_t>(ActionType::Stop) + 1;

constexpr bool is_small_move(ActionType type) {
  return type >= ActionType::TurnBaseToLook && type <= ActionType::RotateHand;
}

}  // namespace

const ActionInfo& info(ActionType type) { return action_table()[static_cast<std::size_t>(type)]; }

std::optional<ActionType> action_named(std::string_view name) {
  for (const ActionInfo& action : action_table()) {
    if (action.name == name) return action.type;
  }
  return std::nullopt;
}

std::optional<ActionType> direct_action(Predicate state) {
  static const auto table = [] {
    std::array<std::optional<ActionType>, kPredicateCount> actions;
    for (const ActionInfo& action : action_table()) {
      if (action.direct) actions[static_cast<std::size_t>(action.changes.front().state)] = action.type;
    }
    return actions;
  }();
  return table[static_cast<std::size_t>(state)];
}

std::span<const ActionInfo> all_actions() { return action_table().first(kDefaultCount); }
std::span<const ActionInfo> extension_actions() { return action_table().subspan(kDefaultCount); }

ActionSet actions_of(Simulator simulator, ActionProfile profile) {
  ActionSet set;
  for (const ActionInfo& action : action_table()) {
    const bool in_profile = profile == ActionProfile::Wide ? !is_small_move(action.type) : !is_extension(action.type);
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
  return index < kFailureCount ? failure_table()[index].name : std::string_view();
}

const FailureInfo& info(Failure failure) { return failure_table()[static_cast<std::size_t>(failure)]; }

std::string_view name_of(ActionArgument argument) {
  switch (argument) {
    case ActionArgument::None:
      return "none";
    case ActionArgument::Object:
      return "object";
    case ActionArgument::ObjectOrRoom:
      return "object or room";
    case ActionArgument::Tool:
      return "tool";
  }
  return "";
}

std::string_view name_of(ActionClass group) {
  switch (group) {
    case ActionClass::Movement:
      return "movement";
    case ActionClass::Reach:
      return "reach";
    case ActionClass::Manipulation:
      return "manipulation";
    case ActionClass::Composite:
      return "composite";
    case ActionClass::Control:
      return "control";
  }
  return "";
}

std::optional<Failure> failure_named(std::string_view name) {
  for (std::size_t i = 0; i < kFailureCount; ++i) {
    if (failure_table()[i].name == name) return static_cast<Failure>(i);
  }
  return std::nullopt;
}

}  // namespace unietp
