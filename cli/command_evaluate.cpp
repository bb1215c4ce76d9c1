#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/evaluate_options.h"
#include "cli/evaluation_backend.h"
#include "cli/evaluation_results.h"
#include "cli/progress_line.h"
#include "cli/served_tasks.h"
#include "cli/show_prompt.h"
#include "core/file_digest.h"
#include "core/file_writer.h"
#include "core/files.h"
#include "core/folder_lock.h"
#include "core/text.h"
#include "core/version.h"
#include "evaluation/agent_files.h"
#include "evaluation/evaluate.h"
#include "evaluation/program_policy.h"
#include "resources/frozen_benchmarks.h"
#include "resources/resources.h"

namespace unietp {
namespace {

namespace fs = std::filesystem;

/// The episodes of a task come one after the other, so that few tasks are needed at a time; homes come again.
constexpr TaskSource::Kept kKeptTasks{.homes = 192, .tasks = 32};

/// All that a run is made of.
struct EvaluationJob {
  EvaluateRequest request;
  TaskSource tasks;
  EpisodePlan plan;
  EvaluationSetup setup;
  BackendTasks backend;  // of another one than our own physics
};

Result<EvaluationSetup> setup_of(const EvaluateChoice& choice, const EvaluateRequest& request, const TaskSource& tasks,
                                 const CommandLine& program) {
  EvaluationSetup setup;
  setup.program_version = program_version();
  setup.program_build = program_build();
  const auto program_file = digest_of_file("/proc/self/exe");
  if (!program_file) return program_file.error();
  setup.program_digest = program_file->sha256;
  const auto knowledge = knowledge_digest(program.folders);
  if (!knowledge) return knowledge.error();
  setup.knowledge_digest = *knowledge;
  const auto digest = dataset_digest(choice.folder);
  if (!digest) return digest.error();
  const auto frozen = FrozenBenchmarks::read(program.folders.benchmarks());
  if (!frozen) return frozen.error();
  setup.dataset = {one_name_of(choice.folder).filename().string(), frozen->name_of(*digest), *digest,
                   static_cast<int>(tasks.size())};
  setup.agent = request.model ? EvaluatedAgent{AgentKind::Model, request.model->endpoint.model}
                              : EvaluatedAgent{AgentKind::Policy, choice.policy};
  if (request.program) {
    auto files = choice.policy.starts_with("python:") ? files_of_python_policy(choice.policy)
                                                      : files_of_command(*request.program);
    if (!files) return files.error();
    setup.agent.files = std::move(*files);
  }
  setup.selection = request.selection;
  setup.settings = request.settings;
  if (request.model) {
    setup.talk = request.model->talk;
    setup.sampling = request.model->sampling;
    setup.price_in = request.model->price.prompt;
    setup.price_out = request.model->price.completion;
  }
  return setup;
}

Result<EvaluationJob> make_job(const EvaluateChoice& choice, const CommandLine& program) {
  auto request = read_evaluate_options(choice, program);
  if (!request) return request.error();
  auto reading = served_tasks({choice.folder, false, "", "", kKeptTasks}, program);
  if (!reading.errors.empty()) return reading.errors.front();
  const bool demonstrated = request->built_in && (request->built_in->kind == BuiltInPolicy::Kind::Replay ||
                                                  request->built_in->kind == BuiltInPolicy::Kind::Noisy);
  auto backend = backend_tasks(choice.backend, choice.folder, *reading.tasks.stored, request->selection, program);
  if (!backend) return backend.error();
  auto plan = plan_episodes(*reading.tasks.stored, request->selection, demonstrated);
  if (!plan) return plan.error();
  auto setup = setup_of(choice, *request, *reading.tasks.stored, program);
  if (!setup) return setup.error();
  setup->backend = choice.backend;
  return EvaluationJob{std::move(*request), std::move(*reading.tasks.stored), std::move(*plan), std::move(*setup),
                       std::move(*backend)};
}

/// Whether the folder may be written: it is new, or has a run that is to be resumed and is made of the same.
Result<Done> check_folder(const EvaluateChoice& choice, const EvaluationSetup& setup) {
  const fs::path manifest = choice.out / kEvaluationManifest;
  const auto usage = [&](const std::string& message) {
    return Error{Error::Kind::Usage, choice.out.string(), {}, message};
  };
  std::error_code code;
  if (!fs::exists(manifest, code)) {
    if (!fs::exists(choice.out, code) || fs::is_empty(choice.out, code)) return Done{};
    return usage("is not empty and holds no evaluation; choose another folder for --out");
  }
  if (!choice.resume)
    return usage("holds an evaluation already; add --resume to go on with it, or choose another --out");
  const auto text = read_file(manifest);
  if (!text) return text.error();
  const auto then = read_evaluation_manifest(manifest.string(), *text);
  if (!then) return then.error();
  const auto lines = differences(then->setup, setup);
  if (!lines.empty())
    return usage("cannot be resumed, since what the run is made of has changed: " + join(lines, "; "));
  return Done{};
}

PolicyMaker policy_of(const EvaluateChoice& choice, const EvaluationJob& job, const CommandLine& program,
                      const std::shared_ptr<EpisodeLog>& log) {
  const EvaluateRequest& request = job.request;
  if (request.model) return model_policies(std::make_shared<ModelOptions>(*request.model), log);
  if (request.built_in) return built_in_policies(*request.built_in, job.tasks, request.selection.seed);
  ProgramOptions options;
  options.arguments = *request.program;
  options.reply_s = choice.attempt_s;
  options.pictures = choice.images != "none";
  options.seed = request.selection.seed;
  options.stop = program.interrupted;
  return program_policies(std::move(options));
}

std::string progress_text(const EvaluationProgress& now) {
  const double rate = now.seconds > 0 ? now.finished_now / now.seconds : 0;
  const int left = now.episodes - now.finished - now.errored;
  std::array<char, 160> text{};
  (void)std::snprintf(text.data(), text.size(), "%d of %d episodes  success %d  errored %d  %.2f/s  %s left",
                      now.finished, now.episodes, now.succeeded, now.errored, rate,
                      rate > 0 ? clock_text(left / rate).c_str() : "-:--");
  std::string line = text.data();
  return now.cost > 0 ? line + "  cost " + number_text(std::round(now.cost * 1e4) / 1e4) : line;
}

void print_summary(const EvaluationManifest& manifest, const EvaluationReport& report, const fs::path& out) {
  const EvaluationTotals& totals = manifest.totals;
  std::printf("%d of %d episodes in %s, %d successful, %d errored\n", totals.finished, totals.episodes,
              out.string().c_str(), report.progress.succeeded, totals.errored);
  if (totals.prompt_tokens + totals.completion_tokens > 0)
    std::printf("tokens     %lld in, %lld out%s\n", static_cast<long long>(totals.prompt_tokens),
                static_cast<long long>(totals.completion_tokens),
                totals.cost > 0 ? (", cost " + number_text(totals.cost)).c_str() : "");
  if (!report.given_up.empty()) std::printf("stopped    %s\n", report.given_up.c_str());
  if (!totals.complete()) std::printf("incomplete: the same command with --resume plays what is missing\n");
}

Exit run_job(const EvaluateChoice& choice, const EvaluationJob& job, const CommandLine& program) {
  const auto lock = FolderLock::take(choice.out);
  if (!lock) return refuse(lock.error());
  if (auto fine = check_folder(choice, job.setup); !fine) return refuse(fine.error());
  const fs::path manifest_file = choice.out / kEvaluationManifest;
  std::error_code code;
  if (!fs::exists(manifest_file, code)) {
    EvaluationManifest begun{job.setup, {}, {}, choice.report_pictures};
    begun.totals.episodes = static_cast<int>(job.plan.episodes.size());
    if (auto done = write_file(manifest_file, to_text(begun)); !done) return refuse(done.error());
  }
  auto opened = EpisodeLog::open(choice.out);
  if (!opened) return refuse(opened.error());
  const auto log = std::make_shared<EpisodeLog>(std::move(*opened));
  if (job.plan.without_demonstration > 0)
    (void)std::fprintf(stderr, "left out: %d tasks in a mode that they have no demonstration of\n",
                       job.plan.without_demonstration);
  const auto judging = judging_data(job.tasks, program);
  if (!judging) return refuse(judging.error());
  auto watched = WatchedEpisodes::begin(choice.out, *judging);
  if (!watched) return refuse(watched.error());
  ProgressLine line(program.terminal);
  EvaluationOptions options;
  options.watcher = watched->watchers();
  options.simulator = job.backend.simulators(choice.attempt_s, program);
  options.at_once = job.request.at_once;
  options.first_wait_s = choice.first_wait_s;
  options.stop = program.interrupted;
  options.progress = [&](const EvaluationProgress& now) { line.draw(progress_text(now)); };
  const auto report =
      evaluate(job.plan, job.tasks, job.setup.settings, policy_of(choice, job, program, log), *log, options);
  line.wipe();
  if (!report) return refuse(report.error());
  if (report->interrupted) {
    (void)std::fprintf(stderr, "interrupted with %d of %d episodes; run the same command with --resume to continue\n",
                       report->progress.finished, report->progress.episodes);
    return Exit::Interrupted;
  }
  const auto manifest = write_evaluation(choice.out, job.setup, job.plan, *log, choice.report_pictures);
  if (!manifest) return refuse(manifest.error());
  print_summary(*manifest, *report, choice.out);
  if (const Exit exit = write_and_print_results(choice.out, *judging, *watched, program.processors); exit != Exit::Ok)
    return exit;
  return manifest->totals.complete() ? Exit::Ok : Exit::Wrong;
}

Exit evaluate_command(const EvaluateChoice& choice, const CommandLine& program) {
  const auto job = make_job(choice, program);
  if (!job) return refuse(job.error());
  if (!choice.show_prompt.empty()) return show_prompt(choice.show_prompt, choice.out, job->request, job->tasks);
  if (choice.dry_run) return show_plan(job->plan, job->request, job->tasks);
  if (choice.out.empty()) return refuse({Error::Kind::Usage, "--out", {}, "expected a folder for the results"});
  return run_job(choice, *job, program);
}

}  // namespace

void add_evaluate_command(CommandParser& app, CommandLine& program) {
  auto choice = std::make_shared<EvaluateChoice>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("evaluate", "Run a model or a policy over a data set and record what happens");
  command->explain(
      "Plays every task of a data set with a language model (--model, at an OpenAI-compatible server), a policy of the "
      "program, a Python class, or any program that speaks JSON lines, and writes episodes.jsonl, timing.jsonl and "
      "manifest.json to the folder --out. Every reply is on disk before it is used: a run that is killed goes on with "
      "--resume and loses at most the replies that were on their way.\n\nWhat is not the agent's doing is no failure "
      "of "
      "its: a server that fails, or a policy's program that ends, is tried again, and then the episode is recorded as "
      "errored; --resume tries it again. The exit code is 0 when every episode was played, else 1. "
      "docs/evaluation.md describes prompts, protocols and files.",
      {{"unietp evaluate out/benchmark --policy replay --out out/replay", "the stored demonstrations; all succeed"},
       {"unietp evaluate out/benchmark --model gpt-4o-mini --llm-url https://api.openai.com/v1 --modes M1,M2 --out "
        "out/mini",
        "a model, which is sent pictures"},
       {"unietp evaluate out/benchmark --model any --llm-url http://localhost:8080/v1 --images none --limit 20 --out "
        "out/small",
        "a model on this machine that cannot see"},
       {"unietp evaluate out/mine --policy \"python3 agent.py\" --out out/agent", "your own program"},
       {"unietp evaluate out/mine --backend virtualhome --policy replay --out out/there",
        "acted out in VirtualHome's graph simulator, too"},
       {"unietp evaluate out/mine --show-prompt ai2thor-00001:3", "exactly what a model is sent at the third step"}});
  add_evaluate_options(*command, *choice);
  command->callback([choice, &program] { program.exit = evaluate_command(*choice, program); });
}

}  // namespace unietp
