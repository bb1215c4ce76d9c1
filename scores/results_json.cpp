#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "scores/figures.h"
#include "scores/result_files.h"
#include "scores/result_tables.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Interval& interval) { return {interval.low, interval.high}; }

Json json_of(const Figures& f) {
  Json json{{"episodes", f.episodes},
            {"errored", f.errored},
            {"successes", f.successes},
            {"stopped_successes", f.stopped_successes},
            {"success_rate", f.success_rate()},
            {"interval", json_of(f.interval)},
            {"bounds", json_of(f.bounds)},
            {"progress", f.progress},
            {"steps", f.steps},
            {"failures", f.failures},
            {"with_plan", f.with_plan},
            {"efficiency", f.efficiency},
            {"wrong_stops", f.wrong_stops},
            {"premature_stops", f.premature_stops},
            {"missed_stops", f.missed_stops},
            {"replies", f.replies},
            {"actions", f.actions},
            {"no_json", f.no_json},
            {"truncated", f.truncated},
            {"unknown_action", f.unknown_action},
            {"bad_argument", f.bad_argument},
            {"boxes", f.boxes},
            {"hits", f.hits},
            {"overlap", f.overlap},
            {"prompt_tokens", f.prompt_tokens},
            {"completion_tokens", f.completion_tokens},
            {"cost", f.cost}};
  if (f.bootstrap) json["bootstrap"] = json_of(*f.bootstrap);
  return json;
}

/// The figures of each value that the episodes have of a field, in order of the values.
template <class Field>
Json by(const Episodes& episodes, bool repeated, const Field& field) {
  std::map<std::string, Episodes> groups;
  for (const EpisodeScore* one : episodes) groups[field(*one)].push_back(one);
  Json json = Json::array();
  for (const auto& [name, group] : groups) {
    Json figures{{"name", name}};
    figures.update(json_of(figures_of(group, repeated)));
    json.push_back(std::move(figures));
  }
  return json;
}

Json failures_json(const Episodes& episodes) {
  std::map<std::pair<std::string, std::string>, int> counts;  // by class and split
  for (const EpisodeScore* one : episodes) {
    if (!one->classes.empty()) ++counts[{one->classes.front(), one->split}];
  }
  Json json = Json::array();
  for (const auto& [key, count] : counts)
    json.push_back({{"class", key.first}, {"split", key.second}, {"episodes", count}});
  return json;
}

Json mode_json(const ScoredRun& run, Mode mode) {
  const bool repeated = is_repeated(run);
  const auto episodes = episodes_where(run, [&](const EpisodeScore& one) { return one.key.mode == mode; });
  Json json{
      {"mode", name_of(mode)},
      {"all", json_of(figures_of(episodes, repeated))},
      {"by_split", by(episodes, repeated, [](const EpisodeScore& one) { return one.split; })},
      {"by_simulator", by(episodes, repeated, [](const EpisodeScore& one) { return one.simulator; })},
      {"by_template", by(episodes, repeated, [](const EpisodeScore& one) { return one.template_name; })},
      {"by_held_out", by(episodes, repeated,
                         [](const EpisodeScore& one) { return one.simulator + (one.held_out ? " unseen" : " seen"); })},
      {"failures", failures_json(episodes)}};
  Json repeats = Json::array();
  if (repeated) {
    for (const PassFigures& one : pass_figures(episodes))
      repeats.push_back({{"k", one.k}, {"tasks", one.tasks}, {"pass_at", one.at}, {"pass_all", one.all}});
  }
  json["repeats"] = std::move(repeats);
  if (const auto timed = run.latency.find(mode); timed != run.latency.end()) {
    const LatencyFigures& l = timed->second;
    json["latency_s"] = {{"replies", l.replies},
                         {"mean", l.mean},
                         {"median", l.median},
                         {"percentile_95", l.percentile_95},
                         {"total", l.total}};
  }
  return json;
}

/// The standard error of a rate, from its interval's half width: what lm-evaluation-harness calls stderr.
double standard_error(const Figures& figures) {
  const double p = figures.success_rate();
  return figures.finished() == 0 ? 0 : std::sqrt(p * (1 - p) / figures.finished());
}

}  // namespace

std::string results_json(const ScoredRun& run, const std::string& manifest_digest) {
  const EvaluationSetup& setup = run.manifest.setup;
  Json json{{"format", "unietp-results/1"},
            {"manifest_sha256", manifest_digest},
            {"conditions", conditions_of(std::span(&run, 1))},
            {"benchmark", setup.dataset.version},
            {"dataset", setup.dataset.digest},
            {"backend", setup.backend},
            {"agent", setup.agent.name},
            {"complete", run.complete()},
            {"missing", run.missing()},
            {"modes", Json::array()}};
  for (const Mode mode : modes_of(run)) json["modes"].push_back(mode_json(run, mode));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string lm_eval_json(const ScoredRun& run) {
  const EvaluationSetup& setup = run.manifest.setup;
  const std::string version = setup.dataset.version.empty() ? setup.dataset.digest : setup.dataset.version;
  Json results = Json::object(), groups = Json::object(), configs = Json::object(), versions = Json::object(),
       shots = Json::object(), better = Json::object(), samples = Json::object();
  const auto add = [&](const std::string& task, const Episodes& episodes) {
    const Figures f = figures_of(episodes, is_repeated(run));
    results[task] = {{"alias", task},
                     {"success_rate,none", f.success_rate()},
                     {"success_rate_stderr,none", standard_error(f)},
                     {"progress,none", f.progress}};
    configs[task] = {{"task", task}, {"dataset_path", setup.dataset.name}, {"output_type", "generate_until"}};
    versions[task] = version;
    shots[task] = 0;
    better[task] = {{"success_rate", true}, {"progress", true}};
    samples[task] = {{"original", f.episodes}, {"effective", f.finished()}};
  };
  for (const Mode mode : modes_of(run)) {
    const std::string whole = "unietp_" + std::string(name_of(mode));
    add(whole, episodes_where(run, [&](const EpisodeScore& one) { return one.key.mode == mode; }));
    Json& parts = groups[whole] = Json::array();
    for (const SplitColumn& column : split_columns()) {
      const auto episodes = episodes_where(
          run, [&](const EpisodeScore& one) { return one.key.mode == mode && one.split == column.split; });
      if (episodes.empty()) continue;
      const std::string task = whole + "_" + std::string(column.split);
      add(task, episodes);
      parts.push_back(task);
    }
  }
  const Json json{{"results", std::move(results)},
                  {"group_subtasks", std::move(groups)},
                  {"configs", std::move(configs)},
                  {"versions", std::move(versions)},
                  {"n-shot", std::move(shots)},
                  {"higher_is_better", std::move(better)},
                  {"n-samples", std::move(samples)},
                  {"config", {{"model", name_of(setup.agent.kind)}, {"model_args", setup.agent.name}}},
                  {"model_name", setup.agent.name},
                  {"unietp_version", setup.program_version}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::map<std::string, std::string> result_files(const ScoredRun& run, const std::string& manifest_digest) {
  const auto tables = result_tables(std::span(&run, 1));
  std::string scores;
  for (const EpisodeScore& one : run.scores) scores += score_line(one) + "\n";
  return {{kScoresFile, std::move(scores)},    {"results.json", results_json(run, manifest_digest)},
          {"lm_eval.json", lm_eval_json(run)}, {"tables.md", to_markdown(tables)},
          {"tables.tex", to_latex(tables)},    {"tables.csv", to_csv(tables)}};
}

}  // namespace unietp
