#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "expert/execution_tree.h"
#include "simulation/mode_episode.h"

namespace unietp {

/// How an agent of the mode asks for the action, nullopt when it cannot; in M3 only of what shows clearly.
std::optional<Command> clearly_said(const ModeEpisode& episode, const Action& action);

/// Says the action so and does it. What cannot be said fails and does not count.
Outcome do_in(ModeEpisode& episode, const Action& action);

/// Executes actions from the start of an execution tree under rules, one after the other, whether they
/// succeed or not. A copy costs next to nothing and is independent.
class Rollout {
 public:
  /// The tree must outlive it.
  Rollout(ExecutionTree& executions, const ModeRules& rules);

  /// Executes one action more, or several.
  Outcome go_on(const Action& action);
  void go_on(std::span<const Action> actions);

  const ModeEpisode& episode() const { return episode_; }  // after the actions so far
  /// Those that succeeded.
  const std::vector<Action>& done() const { return done_; }
  /// Truth of the goal, by the direct evaluator, on what happened so far.
  bool reaches_goal() const { return executions_->reaches_goal(moments_); }

 private:
  ExecutionTree* executions_;
  ModeEpisode episode_;
  std::vector<MomentId> moments_;  // the start, then those that each successful action led through
  std::vector<Action> done_;
};

}  // namespace unietp
