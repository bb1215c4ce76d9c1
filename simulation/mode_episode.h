#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/command.h"
#include "simulation/feedback.h"
#include "simulation/mode_rules.h"
#include "simulation/world.h"

namespace unietp {

/// An episode under the rules of a mode, on top of a world: commands of the agent are translated to actions on ids or
/// refused; steps and failures are counted. A refusal is a failed step that changes nothing else.
///  - M1: any id.
///  - M2: rooms and furniture by id; a movable object only after it has been in view, and as a target of `go_to` only
///    while it is in view.
///  - M3: rooms by id; objects by boxes, which are matched to the boxes of the current picture.
/// The held object, which is not in the picture, may be named by its id in M1 and M2.
/// Deterministic; copies are independent. What the world refers to must outlive the episode.
class ModeEpisode {
 public:
  ModeEpisode(World start, Mode mode) : world_(std::move(start)), mode_(mode) {}

  /// Performs a command. Unknown actions, wrong arguments and what the mode does not allow are failed steps with
  /// feedback. In M2 and M3 no sentence holds an id of the scene. After the end nothing happens and nothing counts.
  Outcome step(const Command& command);
  /// Whether it was stopped or has reached a limit of the mode.
  bool over() const;
  /// Commands so far, and how many of them failed; those after the end do not count.
  int steps() const { return steps_; }
  int failures() const { return failures_; }

  Mode mode() const { return mode_; }
  const World& world() const { return world_; }
  /// Objects in the picture before the next step, sorted by id: in M1 and M2 those within the limit of sight, in M3
  /// all.
  const std::vector<VisibleObject>& visible() const;
  /// The command for an action in the mode; nullopt when the mode has no way to name its object now. The action may
  /// still fail in the world.
  std::optional<Command> command_for(const Action& action) const;

 private:
  std::variant<Action, FailureDetail> action_of(const Command& command) const;
  std::optional<FailureCause> refusal_cause(const ActionInfo& about, const std::string& id) const;
  const VisibleObject* in_view(std::string_view id) const;
  bool was_seen(std::string_view id) const;  // was in view before some step
  const VisibleObject* best_match(const PixelBox& box) const;

  World world_;
  Mode mode_;
  std::vector<MomentId> moments_seen_;  // M2: the moments before each step; their views are computed on demand
  int steps_ = 0, failures_ = 0;
};

}  // namespace unietp
