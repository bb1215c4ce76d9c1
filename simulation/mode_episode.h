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

/// An episode under the rules of a mode, which stand above the world: what the agent says is made an action on ids, or
/// refused; steps and failures are counted. A refusal is a failed step that changes nothing else.
///  - M1: any id.
///  - M2: rooms and furniture by id. Something movable only once the camera has shown it, and `go_to` it only while it
///    is in view or in no need of going (then the world says so).
///  - M3: rooms by id; objects by boxes, which are held against those of the whole picture now.
/// What is in the hand may be named by its id in M1 and M2; no picture shows it.
/// Deterministic; copies are independent. What the world refers to must outlive the episode.
class ModeEpisode {
 public:
  ModeEpisode(World start, Mode mode) : world_(std::move(start)), mode_(mode) {}

  /// An unknown action, a wrong number or kind of arguments, what the mode does not offer or let name: all failed steps
  /// with a sentence. In M2 and M3 no sentence holds an id of the scene. After the end nothing happens and nothing
  /// counts.
  Outcome step(const Command& command);
  /// Stopped, or a limit of the mode is reached.
  bool over() const;
  int steps() const { return steps_; }
  int failures() const { return failures_; }

  Mode mode() const { return mode_; }
  const World& world() const { return world_; }
  /// What is in the picture before the next step, by id: in M1 and M2 what is near enough to be told of, in M3 all.
  const std::vector<VisibleObject>& visible() const;
  /// The command by which an agent of the mode would ask for an action now; nullopt when it has no way to name its
  /// object. The world may still refuse it.
  std::optional<Command> said(const Action& action) const;

 private:
  std::variant<Action, FailureDetail> action_of(const Command& command) const;
  std::optional<FailureCause> refused(const ActionInfo& about, const std::string& id) const;
  const VisibleObject* in_view(std::string_view id) const;
  bool was_seen(std::string_view id) const;  // before some step
  const VisibleObject* best_match(const PixelBox& box) const;

  World world_;
  Mode mode_;
  std::vector<MomentId> looked_at_;  // M2: the moments before its steps; what they show is looked at when asked for
  int steps_ = 0, failures_ = 0;
};

}  // namespace unietp
