#include "scores/figures.h"

#include <algorithm>
#include <map>

#include "scores/bootstrap.h"
#include "scores/clustered_interval.h"
#include "scores/pass_rates.h"

namespace unietp {
namespace {

/// Every bootstrap draws from the same stream, so that it depends only on its episodes.
constexpr std::uint64_t kBootstrapSeed = 1;

std::vector<ClusterCount> by_home(const Episodes& episodes) {
  std::map<std::string, ClusterCount> homes;
  for (const EpisodeScore* one : episodes) {
    if (one->errored()) continue;
    ClusterCount& home = homes[one->layout];
    home.successes += one->success ? 1 : 0;
    home.episodes += 1;
  }
  std::vector<ClusterCount> clusters;
  for (const auto& [name, count] : homes) clusters.push_back(count);
  return clusters;
}

void add(Figures& all, const EpisodeScore& one) {
  all.successes += one.success ? 1 : 0;
  const bool stopped = one.end == EpisodeOutcome::Stop;
  all.stopped_successes += one.success && stopped ? 1 : 0;
  all.wrong_stops += !one.success && stopped ? 1 : 0;
  all.premature_stops += one.premature_stop ? 1 : 0;
  all.missed_stops += one.missed_stop ? 1 : 0;
  all.progress += one.progress;
  all.steps += one.steps;
  all.failures += one.failures;
  if (one.success && one.shortest) {
    ++all.with_plan;
    all.efficiency += one.steps <= *one.shortest ? 1 : *one.shortest / static_cast<double>(one.steps);
  }
  all.replies += one.replies;
  all.actions += one.actions;
  all.no_json += one.no_json;
  all.truncated += one.truncated;
  all.unknown_action += one.unknown_action;
  all.bad_argument += one.bad_argument;
  all.boxes += one.boxes;
  all.hits += one.hits;
  all.overlap += one.overlap;
  all.prompt_tokens += one.prompt_tokens;
  all.completion_tokens += one.completion_tokens;
  all.cost += one.cost;
}

}  // namespace

Episodes episodes_where(const ScoredRun& run, const std::function<bool(const EpisodeScore&)>& keeps) {
  Episodes kept;
  for (const EpisodeScore& one : run.scores) {
    if (keeps(one)) kept.push_back(&one);
  }
  return kept;
}

Figures figures_of(const Episodes& episodes, bool repeated) {
  Figures all;
  for (const EpisodeScore* one : episodes) {
    ++all.episodes;
    all.errored += one->errored() ? 1 : 0;
    if (!one->errored()) add(all, *one);
  }
  if (repeated) {
    const auto homes = by_home(episodes);
    all.interval = clustered_interval(homes);
    all.bootstrap = bootstrap_interval(homes, Rng(kBootstrapSeed));
  } else {
    all.interval = wilson_interval(all.successes, all.finished());
  }
  const double n = all.episodes;
  if (all.episodes > 0) all.bounds = {all.successes / n, (all.successes + all.errored) / n};
  const auto mean = [](double& sum, int count) { sum = count == 0 ? 0 : sum / count; };
  mean(all.progress, all.finished());
  mean(all.steps, all.finished());
  mean(all.failures, all.finished());
  mean(all.efficiency, all.with_plan);
  mean(all.overlap, all.hits);
  return all;
}

std::vector<PassFigures> pass_figures(const Episodes& episodes) {
  std::map<std::string, std::pair<int, int>> tasks;  // finished repeats, successes
  int most = 0;
  for (const EpisodeScore* one : episodes) {
    if (one->errored()) continue;
    auto& [repeats, successes] = tasks[one->key.task];
    most = std::max(most, ++repeats);
    successes += one->success ? 1 : 0;
  }
  std::vector<PassFigures> figures;
  for (int k = 1; k <= most; ++k) {
    PassFigures one{k, 0, 0, 0};
    for (const auto& [task, counts] : tasks) {
      if (counts.first < k) continue;
      ++one.tasks;
      one.at += pass_at(counts.first, counts.second, k);
      one.all += pass_all(counts.first, counts.second, k);
    }
    one.at /= one.tasks;
    one.all /= one.tasks;
    figures.push_back(one);
  }
  return figures;
}

std::vector<StepRange> step_ranges(const Episodes& episodes, int limit) {
  constexpr int kRanges = 10;
  const int width = std::max(1, (limit + kRanges - 1) / kRanges);
  std::vector<StepRange> ranges;
  for (int i = 0; i < kRanges; ++i) ranges.push_back({i * width + 1, (i + 1) * width, 0, 0});
  for (const EpisodeScore* one : episodes) {
    if (one->errored()) continue;
    StepRange& range = ranges[static_cast<std::size_t>(std::clamp((one->steps - 1) / width, 0, kRanges - 1))];
    ++range.episodes;
    range.successes += one->success ? 1 : 0;
  }
  return ranges;
}

std::vector<Mode> modes_of(const ScoredRun& run) {
  std::vector<Mode> modes;
  for (const Mode mode : kModes) {
    if (std::any_of(run.scores.begin(), run.scores.end(), [&](const auto& one) { return one.key.mode == mode; }))
      modes.push_back(mode);
  }
  return modes;
}

bool is_repeated(const ScoredRun& run) {
  return std::any_of(run.scores.begin(), run.scores.end(), [](const auto& one) { return one.key.repeat > 1; });
}

int percent_of(int successes, int trials) {
  return trials == 0 ? 0 : static_cast<int>((std::int64_t{200} * successes + trials) / (std::int64_t{2} * trials));
}

}  // namespace unietp
