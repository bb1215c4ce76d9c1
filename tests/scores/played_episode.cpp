#include "tests/scores/played_episode.h"

#include <stdexcept>

namespace unietp::testing {

PlayedEpisode played(const SharedTask& task, const Settings& settings, const std::vector<std::string>& replies,
                     bool errored) {
  auto environment = Environment::make(task, settings);
  if (!environment) throw std::runtime_error(format(environment.error()));
  PlayedEpisode episode;
  EpisodeRecord& record = episode.record;
  record.key = {task->text.id, settings.rules.mode, 1};
  record.simulator = name_of(task->simulator);
  record.split = task->text.split;
  record.template_name = task->text.template_name;
  record.layout = task->text.layout;
  for (const std::string& reply : replies) {
    if (environment->over()) break;
    EpisodeStep step;
    step.reply = reply;
    const StepResult result = environment->step(reply);
    for (const ExecutedAction& one : result.executed) {
      step.actions.push_back({one.command, one.outcome.success, std::string(name_of(one.outcome.failure)),
                              one.outcome.feedback, one.counted});
      // The environment keeps what it expected inside the sentence for the agent.
      const std::string start = "Your answer names no action: ";
      if (one.outcome.feedback.starts_with(start))
        step.unreadable = one.outcome.feedback.substr(start.size(), one.outcome.feedback.size() - start.size() - 1);
    }
    step.progress = environment->privileged().progress;
    record.steps.push_back(std::move(step));
  }
  const PrivilegedState last = environment->privileged();
  record.end = outcome_named(last.ended_by).value_or(EpisodeOutcome::Errored);
  record.success = environment->over() && last.success;
  record.progress = last.progress;
  record.counted = last.steps;
  record.failures = last.failures;
  if (errored) record.error = EpisodeError{EpisodeErrorKind::RateLimit, "status 429"};
  auto replayed = replay_episode(record, task, settings);
  if (!replayed) throw std::runtime_error(format(replayed.error()));
  episode.replayed = std::move(*replayed);
  return episode;
}

}  // namespace unietp::testing
