#include "cli/evaluation_results.h"

#include <cstdio>

#include "cli/held_out_templates.h"
#include "cli/served_tasks.h"
#include "core/files.h"
#include "core/in_quotes.h"
#include "evaluation/evaluate.h"
#include "evaluation/evaluation_manifest.h"
#include "scores/result_tables.h"
#include "scores/write_results.h"

namespace unietp {

Result<JudgingData> judging_data(const TaskSource& tasks, const CommandLine& program) {
  const auto names = held_out_templates(program.folders);
  if (!names) return names.error();
  return JudgingData{tasks, {names->begin(), names->end()}};
}

Exit write_and_print_results(const std::filesystem::path& folder, const JudgingData& judging,
                             const WatchedEpisodes& watched, int threads) {
  const auto run = write_results(folder, {judging, threads, &watched});
  if (!run) return refuse(run.error());
  for (const ResultTable& table : result_tables(std::span(&*run, 1))) {
    if (table.id == "main" || table.id == "m3" || table.id == "failures")
      std::printf("\n%s", to_plain_text({table}).c_str());
  }
  std::printf("\nmore in %s and %s\n", (folder / kReportFile).c_str(), (folder / "tables.md").c_str());
  return Exit::Ok;
}

bool is_evaluation(const std::filesystem::path& folder) {
  const auto text = read_file(folder, kEvaluationManifest);
  return text && text->substr(0, 200).find("\"unietp-evaluation/") != std::string::npos;
}

Exit validate_evaluation(const std::filesystem::path& folder, const std::filesystem::path& dataset, int threads,
                         const CommandLine& program) {
  const auto text = read_file(folder, kEvaluationManifest);
  if (!text) return refuse(text.error());
  const std::string where = (folder / kEvaluationManifest).string();
  const auto manifest = read_evaluation_manifest(where, *text);
  if (!manifest) return refuse(manifest.error());
  if (dataset.empty())
    return refuse({Error::Kind::Usage,
                   folder.string(),
                   {},
                   "is an evaluation; name the data set that it was made on with --dataset FOLDER (" +
                       in_quotes(manifest->setup.dataset.name) + ")"});
  const auto digest = dataset_digest(dataset);
  if (!digest) return refuse(digest.error());
  if (*digest != manifest->setup.dataset.digest)
    return refuse({Error::Kind::Usage, dataset.string(), {}, "is not the data set that this evaluation was made on"});
  const auto frozen = FrozenBenchmarks::read(program.folders.benchmarks());
  if (!frozen) return refuse(frozen.error());
  const std::string version = frozen->name_of(*digest);
  const auto reading = served_tasks({dataset, false, "", "", {}}, program);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const auto judging = judging_data(*reading.tasks.stored, program);
  if (!judging) return refuse(judging.error());
  std::vector<Error> found = check_results(folder, {*judging, threads});
  if (version != manifest->setup.dataset.version)
    found.push_back(
        {Error::Kind::Schema,
         where + "#/setup/dataset/version",
         {},
         "is " + in_quotes(manifest->setup.dataset.version) + ", but the data set is " + in_quotes(version)});
  const EvaluatedAgent& agent = manifest->setup.agent;
  const bool demonstrated =
      agent.kind == AgentKind::Policy && (agent.name == "replay" || agent.name.starts_with("noisy:"));
  const auto plan = plan_episodes(*reading.tasks.stored, manifest->setup.selection, demonstrated);
  if (!plan) return refuse(plan.error());
  if (const auto asked = static_cast<int>(plan->episodes.size()); asked != manifest->totals.episodes)
    found.push_back(
        {Error::Kind::Schema,
         where + "#/totals/episodes",
         {},
         "is " + std::to_string(manifest->totals.episodes) + ", but the settings ask for " + std::to_string(asked)});
  for (const Error& one : found) std::printf("%s\n", format(one).c_str());
  const int episodes = manifest->totals.finished + manifest->totals.errored;
  std::printf("%d episodes executed again, all results computed again: %s\n", episodes,
              found.empty() ? "no problem" : (std::to_string(found.size()) + " problems").c_str());
  return found.empty() ? Exit::Ok : Exit::Wrong;
}

}  // namespace unietp
