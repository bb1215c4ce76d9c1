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
#include "pipeline/library_options.h"
#include "pipeline/progress_line.h"
#include "pipeline/rejection_hints.h"
#include "pipeline/run.h"
#include "pipeline/settle_binding.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Make a data set of verified tasks.\n"
    "\n"
    "  unietp generate --count 40 --seed 1 --out out/first\n"
    "      40 tasks, equally shared by the four simulators and the five splits\n"
    "  unietp generate --count 20 --simulators ai2thor,habitat --splits logical --out out/logic\n"
    "  unietp generate --count 8 --template place-one-on,slice-one --out out/two\n"
    "      of these templates; `unietp template list` names all\n"
    "  unietp generate --count 8 --templates my/templates --template sweep-one --out out/mine\n"
    "      templates of your own load beside the built-in ones\n"
    "  unietp generate --template place-one-on --bind A=Book B=Sofa --out out/book\n"
    "      exactly this, or why not; add --scenes HOME for a home of your choice\n"
    "  unietp generate --count 20 --scenes out/homes --out out/imported\n"
    "      in the homes of these scene files; `unietp scene import` makes them from the simulators' own files\n"
    "  unietp generate --count 20 --modes M1,M2,M3 --out out/modes\n"
    "      each demonstrated in all three modes; docs/modes.md says what each knows and may do\n"
    "  unietp generate --count 40 --seed 1 --out out/first --resume\n"
    "      go on after an interruption; the result is the same to the byte\n"
    "\n"
    "The same options and seed give the same bytes with any number of threads. Work is kept in OUT.partial and "
    "becomes\n"
    "OUT at the end. Exit code 1: some tasks could not be made; the data set holds the others.";

struct Options {
  RunConfiguration configuration;
  RunOptions run;
  std::string simulators, splits, modes;
  std::vector<std::string> binding;
  bool count_given = false;
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
  auto balance = nlohmann::ordered_json::array();
  for (const auto& spread : report.balance)
    balance.push_back({{"dimension", name_of(spread.dimension)},
                       {"values", spread.values},
                       {"effective", spread.effective},
                       {"variation", spread.variation}});
  return {
      {"format", "unietp-generation/1"}, {"out", options.run.out.string()},      {"interrupted", report.interrupted},
      {"tasks", report.tasks},           {"asked", options.configuration.count}, {"candidates", report.candidates},
      {"seconds", report.seconds},       {"balance", std::move(balance)},        {"unfilled", std::move(unfilled)}};
}

/// "templates 59 (as 55.1 equally frequent ones), categories …"
std::string text_of(const std::vector<Spread>& balance) {
  std::vector<std::string> parts;
  for (const auto& spread : balance) {
    std::array<char, 96> text{};
    (void)std::snprintf(text.data(), text.size(), "%s: %d values, as even as %.1f equal ones",
                        std::string(name_of(spread.dimension)).c_str(), spread.values, spread.effective);
    parts.emplace_back(text.data());
  }
  return join(parts, "; ");
}

/// "grounding no-free-place: …; there is no space left: …" from a line of rejections.jsonl.
std::string reason_text(const std::string& line) {
  const auto json = nlohmann::ordered_json::parse(line, nullptr, false);
  if (!json.is_object()) return line;
  const auto reason = json.value("reason", "");
  const std::string hint(hint_for(reason));
  return json.value("stage", "") + " " + reason + ": " + json.value("detail", "") + (hint.empty() ? "" : "; " + hint);
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
  if (!options.json && report.tasks > 1) std::printf("spread over %s\n", text_of(report.balance).c_str());
  for (const auto& slot : report.unfilled)
    log.error("no {} after {} attempts; the last: {}", slot.description, options.configuration.attempts,
              reason_text(slot.last_reason));
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
  if (!options.modes.empty()) {
    auto modes = parse_modes("--modes", options.modes);
    if (!modes) return refuse(modes.error());
    options.configuration.modes = *modes;
  }
  auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  options.configuration.extended = program.folders.extended_library;
  options.configuration.own = reading.resources.own;
  if (!options.scenes.empty()) {
    auto given = given_homes(options.scenes, reading.resources, program.folders);
    if (!given.errors.empty()) return refuse(given.errors);
    if (options.simulators.empty()) options.configuration.simulators = simulators_of(given.scenes);
    options.configuration.scenes = std::move(given.names);
    reading.resources.homes = std::move(given.scenes);
  }

  if (!options.binding.empty()) {
    const BindingRequest request{options.binding, options.count_given, !options.splits.empty(),
                                 !options.simulators.empty() || !options.scenes.empty()};
    const auto refused = settle_binding(request, reading.resources, options.configuration);
    if (!refused) return refuse(refused.error());
    std::printf("%s", refused->c_str());
    if (!refused->empty()) return Exit::Wrong;
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
  auto* count =
      command->add_option("--count", configuration.count, "How many tasks (default: 40; with --bind one a simulator)")
          ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", configuration.seed, "Number that names the run");
  command->add_option("--simulators", options->simulators, "Of ai2thor,virtualhome,habitat,behavior (default: all)");
  command->add_option("--splits", options->splits,
                      "Of atomic,compositional,logical,instance_grounding,linguistic (default: all)");
  command->add_option("--modes", options->modes,
                      "Of M1,M2,M3: each task is demonstrated in all of them, or given up (default: M1, always made)");
  command->add_option("--template", configuration.templates, "Names, as `unietp template list` shows (default: all)")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_library_options(*command, program);
  command
      ->add_option("--bind", options->binding,
                   "Categories for some or all placeholders of the one template: A=Mug B=Fridge")
      ->type_name("A=Mug ...");
  command->add_option("--attempts", configuration.attempts, "Candidates tried for one task before it is given up")
      ->check(CLI::Range(1, 1024));
  command->add_option("--rooms", configuration.rooms, "Rooms of a home")->check(CLI::Range(5, 20));
  command->add_option("--objects", configuration.objects, "Movable objects asked for in a home")
      ->check(CLI::Range(0, 1000));
  command->add_option("--scenes,--scene", options->scenes,
                      "Scene files, folders of them, or homes of the benchmark by name, in place of drawn homes");
  command->add_option("--threads", options->run.threads, "Threads (default: one a processor); never changes the result")
      ->check(CLI::Range(1, 1024));
  command->add_option("--out", options->run.out, "Folder to make")->required();
  command->add_flag("--resume", options->run.resume, "Go on with the unfinished run in OUT.partial");
  command->add_flag("--json", options->json, "Report on stdout as JSON");
  command->callback([options, count, &program] {
    options->count_given = count->count() > 0;
    program.exit = generate(*options, program);
  });
}

}  // namespace unietp
