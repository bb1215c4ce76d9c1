#pragma once

#include <optional>
#include <set>
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
/// refused; steps and failures are counted. A refusal is a failed step that changes nothing else. The modes:
///  - M1: any id.
///  - M2: rooms and furniture by id; a movable object only after it has been in view, and as a target of `go_to` only
///    while it is in view. An id that does not exist is refused as one that was not seen.
///  - M3: rooms by id; objects by boxes, which are matched to the boxes of the current picture.
/// The held object, which is not in the picture, may be named by its id where objects have ids.
/// Deterministic; copies are independent. What the world refers to must outlive the episode.
class ModeEpisode {
 public:
  ModeEpisode(World start, const ModeRules& rules) : world_(std::move(start)), rules_(rules) {}
  ModeEpisode(World start, Mode mode) : ModeEpisode(std::move(start), rules_of(mode)) {}

  /// Performs a command. Unknown actions, wrong arguments and what the rules do not allow are failed steps with
  /// feedback. In M2 and M3 no sentence holds an id of the scene. After the end nothing happens and nothing counts.
  Outcome step(const Command& command);
  /// Takes an answer that is no command as a failed step; `expected`: what the sentence for the agent says of it.
  Outcome refuse(std::string_view expected);
  /// Whether it was stopped or has reached a limit.
  bool over() const;
  /// Commands so far, and how many of them failed; those after the end do not count, nor, with `invalid_is_free`,
  /// invalid ones.
  int steps() const { return steps_; }
  int failures() const { return failures_; }

  const ModeRules& rules() const { return rules_; }  // as given
  const World& world() const { return world_; }
  /// Objects in the picture before the next step, sorted by id: where the agent is told boxes those within the limit of
  /// sight, otherwise all.
  const std::vector<VisibleObject>& visible() const;
  /// The action that the last command stood for, with objects by ids; of a command that the rules refused without
  /// effect.
  const Action& last_action() const { return last_action_; }
  /// The command for an action under the rules; nullopt when there is no way to name its object now. The action may
  /// still fail in the world.
  std::optional<Command> command_for(const Action& action) const;

  /// Drops everything of earlier moments but which objects have been in view, as World::forget.
  void forget();
  /// A copy that shares nothing with this one, as World::apart.
  ModeEpisode apart() const;

 private:
  ModeEpisode(World world, const ModeEpisode& other);
  std::variant<Action, FailureDetail> action_of(const Command& command) const;
  std::optional<FailureDetail> refusal_of(const ActionInfo& about, const std::string& id) const;
  bool may_go_to(const std::string& id) const;
  bool knows(const std::string& id) const;
  bool was_seen(std::string_view id) const;                  // was in view before some step
  const std::string* best_match(const PixelBox& box) const;  // the id of an object in the picture
  /// Whether feedback may say what something is that is not the action's object.
  bool may_name(const FailureReference& other) const;
  Outcome count(ActionResult result);

  World world_;
  ModeRules rules_;
  // Of rules that ask what was seen: the moments before each step, whose views are computed on demand, and what was in
  // view in those that were forgotten.
  std::vector<MomentId> moments_seen_;
  std::set<std::string, std::less<>> seen_;
  Action last_action_;
  int steps_ = 0, failures_ = 0;
};

}  // namespace unietp
