#include "scores/episode_score.h"

#include <algorithm>
#include <utility>

#include "scores/failure_class.h"

namespace unietp {

namespace {

/// Steps of the shortest plan that the data set has for a mode; nullopt: it has none.
std::optional<int> known_plan(const EnvironmentTask& task, Mode mode) {
  for (const TaskRecord::Count& shown : task.text.expert) {
    if (shown.mode == mode) return shown.shortest == 0 ? shown.steps : shown.shortest;
  }
  return std::nullopt;
}

}  // namespace

PartialScore score_episode(const EpisodeRecord& record, const ReplayedEpisode& replayed, const EnvironmentTask& task,
                           bool held_out) {
  PartialScore partial{{}, successful_actions(replayed)};
  EpisodeScore& score = partial.score;
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
  score.missed_stop = missed_stop(record, replayed);
  score.shortest = known_plan(task, record.key.mode);
  for (const FailureClass& one : failure_classes(record, replayed, task)) score.classes.push_back(to_text(one));
  return partial;
}

EpisodeScore finalize_score(PartialScore partial, std::optional<int> fewest) {
  EpisodeScore score = std::move(partial.score);
  if (fewest) score.shortest = std::min(score.shortest.value_or(*fewest), *fewest);
  score.premature_stop =
      score.end == EpisodeOutcome::Stop && !score.success && too_early(partial.successful_actions, score.shortest);
  if (!score.premature_stop) return score;
  const auto place = std::find_if(score.classes.begin(), score.classes.end(), [](const std::string& text) {
    const auto one = failure_class_of(text);
    return one && one->group >= FailureGroup::Stop;
  });
  score.classes.insert(place, to_text(premature_stop()));
  return score;
}

}  // namespace unietp
