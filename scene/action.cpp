#include "scene/action.h"

#include <algorithm>

#include "core/text.h"
#include "scene/action_table.h"

namespace unietp {
namespace {

constexpr std::size_t kDefaultCount = static_cast<std::size_t>(ActionType::Stop) + 1;
constexpr bool is_small_move(ActionType type) {
  return type >= ActionType::TurnBaseToLook && type <= ActionType::RotateHand;
}

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

const ActionInfo& info(ActionType type) { return action_table()[static_cast<std::size_t>(type)]; }

std::optional<ActionType> action_named(std::string_view name) {
  for (const ActionInfo& action : action_table()) {
    if (action.name == name) return action.type;
  }
  return std::nullopt;
}

std::vector<Failure> failures_of(const ActionInfo& action) {
  std::vector<Failure> failures;
  const auto add = [&](Failure failure) {
    if (std::find(failures.begin(), failures.end(), failure) == failures.end()) failures.push_back(failure);
  };
  for (const ActionNeed& need : action.needs) {
    if (need.failure == Failure::InvalidArgument) continue;
    if (need.kind == ActionNeed::Kind::Reach || need.kind == ActionNeed::Kind::ReachOrInHand) {
      for (const Failure failure : {Failure::InsideClosed, Failure::TooFar, Failure::NotVisible}) add(failure);
    } else {
      add(need.failure);
    }
  }
  return failures;
}

std::optional<ActionType> direct_action(Predicate state) {
  static const auto table = [] {
    std::array<std::optional<ActionType>, kPredicateCount> actions;
    for (const ActionInfo& action : action_table()) {
      if (!action.changes.empty()) actions[static_cast<std::size_t>(action.changes.front().state)] = action.type;
    }
    return actions;
  }();
  return table[static_cast<std::size_t>(state)];
}

std::string_view affordance_for(const ActionInfo& action) {
  if (action.changes.empty()) return "";
  for (const ActionNeed& need : action.needs) {
    if (need.kind == ActionNeed::Kind::Affordance) return need.affordance;
    if (need.kind == ActionNeed::Kind::Varies) return info(need.state).group;
  }
  return "";
}

bool is_extension(ActionType type) { return static_cast<std::size_t>(type) >= kDefaultCount; }

std::span<const ActionInfo> all_actions() { return action_table().first(kDefaultCount); }
std::span<const ActionInfo> extension_actions() { return action_table().subspan(kDefaultCount); }

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
  return index < kFailureCount ? failure_table()[index] : std::string_view();
}

std::optional<Failure> failure_named(std::string_view name) {
  for (std::size_t i = 0; i < kFailureCount; ++i) {
    if (failure_table()[i] == name) return static_cast<Failure>(i);
  }
  return std::nullopt;
}

}  // namespace unietp
