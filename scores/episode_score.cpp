#include "scores/episode_score.h"

#include "scores/failure_class.h"

namespace unietp {

EpisodeScore score_episode(const EpisodeRecord& record, const ReplayedEpisode& replayed, const EnvironmentTask& task,
                           std::optional<int> shortest, bool held_out) {
  EpisodeScore score;
  score.key = record.key;
  score.simulator = name_of(task.simulator);
  score.split = task.text.split;
  score.template_name = task.text.template_name;
  score.layout = task.text.layout;
  score.held_out = held_out;
  score.end = record.end;
  score.success = replayed.success;
  score.progress = replayed.progress;
  score.steps = replayed.counted;
  score.failures = replayed.failures;
  score.replies = static_cast<int>(replayed.steps.size());
  for (std::size_t i = 0; i < replayed.steps.size(); ++i) {
    score.prompt_tokens += record.steps[i].prompt_tokens;
    score.completion_tokens += record.steps[i].completion_tokens;
    score.cost += record.steps[i].cost;
    for (const ReplayedAction& action : replayed.steps[i].actions) {
      ++score.actions;
      const auto fault = output_fault(record.steps[i], action.record);
      score.no_json += fault == OutputFault::NoJson ? 1 : 0;
      score.truncated += fault == OutputFault::Truncated ? 1 : 0;
      score.unknown_action += fault == OutputFault::UnknownAction ? 1 : 0;
      score.bad_argument += fault == OutputFault::BadArgument ? 1 : 0;
      if (!action.overlap) continue;
      ++score.boxes;
      if (action.object.empty()) continue;
      ++score.hits;
      score.overlap += *action.overlap;
    }
  }
  score.premature_stop = stopped_early(record, replayed, shortest);
  score.missed_stop = missed_stop(record, replayed);
  score.shortest = shortest;
  for (const FailureClass& one : failure_classes(record, replayed, task, shortest))
    score.classes.push_back(to_text(one));
  return score;
}

}  // namespace unietp
