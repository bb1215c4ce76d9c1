#include "scene/action.h"

#include <algorithm>

namespace unietp {

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

std::string_view affordance_for(const ActionInfo& action) {
  if (!action.direct) return "";
  for (const ActionNeed& need : action.needs) {
    if (need.kind == ActionNeed::Kind::Affordance) return need.affordance;
    if (need.kind == ActionNeed::Kind::Varies) return info(need.state).group;
  }
  return "";
}

bool is_extension(ActionType type) { return type > ActionType::Stop; }

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

}  // namespace unietp
