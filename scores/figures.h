#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scores/episode_score.h"
#include "scores/interval.h"
#include "scores/scored_run.h"

namespace unietp {

/// Some episodes of a run.
using Episodes = std::vector<const EpisodeScore*>;
/// Those for which `keeps` is true, in their order.
Episodes episodes_where(const ScoredRun& run, const std::function<bool(const EpisodeScore&)>& keeps);

/// What some episodes of one run come to. Episodes that errored are counted and are in nothing else.
struct Figures {
  int episodes = 0, errored = 0;
  int successes = 0;                             // the goal is true at the end
  int stopped_successes = 0;                     // and the agent said `stop`
  Interval interval;                             // of the success rate, 95 %
  std::optional<Interval> bootstrap;             // the same by a bootstrap over homes, where tasks were repeated
  Interval bounds;                               // of it if all errored episodes had failed, and if all had succeeded
  double progress = 0, steps = 0, failures = 0;  // means
  int with_plan = 0;                             // successes whose shortest plan is known
  double efficiency = 0;                         // mean of shortest plan / steps over them, at most 1 each
  int wrong_stops = 0;                           // `stop` without the goal
  int premature_stops = 0, missed_stops = 0;
  int replies = 0, actions = 0;
  int no_json = 0, truncated = 0, unknown_action = 0, bad_argument = 0;
  int boxes = 0, hits = 0;
  double overlap = 0;  // mean over the hits
  std::int64_t prompt_tokens = 0, completion_tokens = 0;
  double cost = 0;

  int finished() const { return episodes - errored; }  // episodes with a result
  double success_rate() const { return finished() == 0 ? 0 : successes / static_cast<double>(finished()); }  // 0 to 1
};

/// `repeated`: tasks were done several times, so that the interval is that of clusters, the homes; otherwise Wilson's.
/// Deterministic.
Figures figures_of(const Episodes& episodes, bool repeated);

/// The chance that one of k repeats succeeds, and that all do: means over the tasks with at least k finished repeats.
struct PassFigures {
  int k = 1, tasks = 0;
  double at = 0, all = 0;
};
/// For k from 1 to the most repeats of a task.
std::vector<PassFigures> pass_figures(const Episodes& episodes);

/// Episodes with so many steps, from `first` to `last`.
struct StepRange {
  int first = 0, last = 0, episodes = 0, successes = 0;
};
/// Ten ranges of equal width up to the limit of steps; episodes that errored are left out.
std::vector<StepRange> step_ranges(const Episodes& episodes, int limit);

/// The modes that a run has episodes of.
std::vector<Mode> modes_of(const ScoredRun& run);
/// Whether a run did any task several times.
bool is_repeated(const ScoredRun& run);

/// The rate in whole percent, halves rounded up; exact.
int percent_of(int successes, int trials);

}  // namespace unietp
