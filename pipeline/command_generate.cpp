#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/text.h"
#include "pipeline/commands.h"
#include "pipeline/given_scenes.h"
#include "pipeline/progress_line.h"
#include "pipeline/run.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Make a data set of verified tasks.\n"
    "\n"
    "  unietp generate --count 40 --seed 1 --out out/first\n"
    "      40 tasks, equally shared by the four simulators and the five splits\n"
    "  unietp generate --count 20 --simulators ai2thor,habitat --splits logical --out out/logic\n"
    "  unietp generate --count 8 --templates place-on,slice-one --out out/two\n"
    "  unietp generate --count 20 --scenes out/homes --out out/imported\n"
    "      in the homes of these scene files; `unietp scene import` makes them from the simulators' own files\n"
    "  unietp generate --count 40 --seed 1 --out out/first --resume\n"
    "      go on after an interruption; the result is the same to the byte\n"
    "\n"
    "The same options and seed give the same bytes with any number of threads. Work is kept in OUT.partial and "
    "becomes\n"
    "OUT at the end. Exit code 1: some tasks could not be made; the data set holds the others.";

struct Options {
  RunConfiguration configuration;
  RunOptions run;
  std::string simulators, splits, templates;
  std::vector<std::filesystem::path> scenes;
  bool json = false;
};

std::string progress_text(const RunProgress& now) {
  const double rate = now.seconds > 0 ? now.tasks_now / now.seconds : 0;
  const double yield = now.candidates > 0 ? 100.0 * now.tasks / now.candidates : 0;
  const auto left = rate > 0 ? clock_text((now.asked - now.tasks) / rate) : std::string("-:--");
  std::array<char, 128> text{};
  (void)std::snprintf(text.data(), text.size(), "%d of %d tasks  %d candidates  yield %.0f %%  %.2f tasks/s  %s left",
                      now.tasks, now.asked, now.candidates, yield, rate, left.c_str());
  return text.data();
}

nlohmann::ordered_json json_of(const RunReport& report, const Options& options) {
  auto unfilled = nlohmann::ordered_json::array();
  for (const auto& slot : report.unfilled)
    unfilled.push_back({{"slot", slot.slot}, {"what", slot.description}, {"last", slot.last_reason}});
  return {
      {"format", "unietp-generation/1"}, {"out", options.run.out.string()},      {"interrupted", report.interrupted},
      {"tasks", report.tasks},           {"asked", options.configuration.count}, {"candidates", report.candidates},
      {"seconds", report.seconds},       {"unfilled", std::move(unfilled)}};
}

Exit tell(const RunReport& report, const Options& options, spdlog::logger& log) {
  const auto out = options.run.out.string();
  if (options.json) std::printf("%s\n", json_of(report, options).dump(2).c_str());
  if (report.interrupted) {
    log.warn("interrupted with {} of {} tasks; the same command with --resume goes on from here", report.tasks,
             options.configuration.count);
    return Exit::Interrupted;
  }
  if (!options.json)
    std::printf("%d of %d tasks in %s (%d candidates, %s)\n", report.tasks, options.configuration.count, out.c_str(),
                report.candidates, clock_text(report.seconds).c_str());
  for (const auto& slot : report.unfilled)
    log.error("no {} after {} attempts; the last: {}", slot.description, options.configuration.attempts,
              slot.last_reason);
  return report.unfilled.empty() ? Exit::Ok : Exit::Wrong;
}

std::vector<Simulator> simulators_of(const std::vector<Scene>& scenes) {
  std::vector<Simulator> found;
  for (const auto simulator : kSimulators) {
    const auto own = [&](const Scene& scene) { return scene.simulator == simulator; };
    if (std::any_of(scenes.begin(), scenes.end(), own)) found.push_back(simulator);
  }
  return found;
}

Exit generate(Options& options, const CommandLine& program) {
  spdlog::logger log("unietp", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  log.set_pattern("%l: %v");
  if (!options.simulators.empty()) {
    auto simulators = parse_simulators("--simulators", options.simulators);
    if (!simulators) return refuse(simulators.error());
    options.configuration.simulators = *simulators;
  }
  if (!options.splits.empty()) {
    auto splits = parse_splits("--splits", options.splits);
    if (!splits) return refuse(splits.error());
    options.configuration.splits = *splits;
  }
  for (const auto& name : split(options.templates, ',')) {
    if (!trim(name).empty()) options.configuration.templates.emplace_back(trim(name));
  }
  auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  if (!options.scenes.empty()) {
    auto given = read_given_scenes(options.scenes, reading.resources.backends);
    if (!given.errors.empty()) return refuse(given.errors);
    if (options.simulators.empty()) options.configuration.simulators = simulators_of(given.scenes);
    options.configuration.scenes = std::move(given.names);
    reading.resources.homes = std::move(given.scenes);
  }

  ProgressLine line(program.terminal);
  options.run.licences = program.folders.licences();
  options.run.stop = program.interrupted;
  if (program.terminal) options.run.progress = [&line](const RunProgress& now) { line.draw(progress_text(now)); };
  const auto report = run_generation(options.configuration, reading.resources, options.run);
  line.wipe();
  if (!report) return refuse(report.error());
  return tell(*report, options, log);
}

}  // namespace

void add_generate_command(CLI::App& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  options->run.threads = program.processors;
  auto* command = app.add_subcommand("generate", kHelp);
  auto& configuration = options->configuration;
  command->add_option("--count", configuration.count, "How many tasks")->check(CLI::Range(1, 1000000));
  command->add_option("--seed", configuration.seed, "Number that names the run");
  command->add_option("--simulators", options->simulators, "Of ai2thor,virtualhome,habitat,behavior (default: all)");
  command->add_option("--splits", options->splits,
                      "Of atomic,compositional,logical,instance_grounding,linguistic (default: all)");
  command->add_option("--templates", options->templates, "Names, as `unietp template list` shows (default: all)");
  command->add_option("--attempts", configuration.attempts, "Candidates tried for one task before it is given up")
      ->check(CLI::Range(1, 1024));
  command->add_option("--rooms", configuration.rooms, "Rooms of a home")->check(CLI::Range(5, 20));
  command->add_option("--objects", configuration.objects, "Movable objects asked for in a home")
      ->check(CLI::Range(0, 1000));
  command->add_option("--scenes", options->scenes, "Scene files, or folders of them, in place of drawn homes");
  command->add_option("--threads", options->run.threads, "Threads (default: one a processor); never changes the result")
      ->check(CLI::Range(1, 1024));
  command->add_option("--out", options->run.out, "Folder to make")->required();
  command->add_flag("--resume", options->run.resume, "Go on with the unfinished run in OUT.partial");
  command->add_flag("--json", options->json, "Report on stdout as JSON");
  command->callback([options, &program] { program.exit = generate(*options, program); });
}

}  // namespace unietp
