#include "expert/rollout.h"

#include <algorithm>

#include "simulation/view.h"

namespace unietp {

std::optional<Command> clearly_said(const ModeEpisode& episode, const Action& action) {
  auto command = episode.command_for(action);
  if (!command) return std::nullopt;
  const bool clear = std::all_of(command->args.begin(), command->args.end(), [](const Argument& argument) {
    return !argument.box || shows_clearly(*argument.box);
  });
  return clear ? command : std::nullopt;
}

Outcome do_in(ModeEpisode& episode, const Action& action) {
  const auto command = clearly_said(episode, action);
  if (!command) return {false, Failure::NotInView, to_text(action) + " cannot be said from here"};
  return episode.step(*command);
}

Rollout::Rollout(ExecutionTree& executions, const ModeRules& rules)
    : executions_(&executions), episode_(executions.world(), rules), moments_{executions.world().moment()} {}

Outcome Rollout::go_on(const Action& action) {
  Outcome outcome = do_in(episode_, action);
  if (!outcome.success) return outcome;
  executions_->read(moments_.back(), episode_.world());
  for (const PassedMoment& passed : episode_.world().passed()) moments_.push_back(passed.moment);
  moments_.push_back(episode_.world().moment());
  done_.push_back(action);
  return outcome;
}

void Rollout::go_on(std::span<const Action> actions) {
  for (const Action& action : actions) (void)go_on(action);
}

}  // namespace unietp
