#include <algorithm>
#include <cstdio>
#include <memory>

#include "authoring/binding_request.h"
#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/library_options.h"
#include "cli/run_command.h"
#include "core/limits.h"
#include "homes/given_scenes.h"

namespace unietp {
namespace {

struct GenerateOptions : RunCommand {
  std::string simulators, splits, modes;
  WriterChoice writer;
  std::vector<std::string> binding;
  bool count_given = false;
  std::vector<std::filesystem::path> scenes;
  std::filesystem::path assets;
};

std::vector<Simulator> simulators_of(const std::vector<Scene>& scenes) {
  std::vector<Simulator> found;
  for (const auto simulator : kSimulators) {
    const auto own = [&](const Scene& scene) { return scene.simulator == simulator; };
    if (std::any_of(scenes.begin(), scenes.end(), own)) found.push_back(simulator);
  }
  return found;
}

Exit generate(GenerateOptions& options, const CommandLine& program) {
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
    auto modes = parse_modes_to_make("--modes", options.modes);
    if (!modes) return refuse(modes.error());
    options.configuration.modes = *modes;
  }
  if (options.configuration.native && options.scenes.empty())
    return refuse({Error::Kind::Usage, "--native", {}, "needs --scenes, the simulators' own scenes"});
  if (!options.assets.empty() && !options.configuration.native)
    return refuse({Error::Kind::Usage, "--assets", {}, "is for --native, whose --scenes takes the simulators' files"});
  auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  options.configuration.extended = program.folders.extended_library;
  options.configuration.own = reading.resources.own;
  if (!options.scenes.empty()) {
    auto given = options.configuration.native
                     ? native_homes(options.scenes, options.assets, reading.resources, program.folders)
                     : given_homes(options.scenes, reading.resources, program.folders);
    if (!given.errors.empty()) return refuse(given.errors);
    if (options.simulators.empty()) options.configuration.simulators = simulators_of(given.scenes);
    options.configuration.scenes = std::move(given.names);
    reading.resources.homes = std::move(given.scenes);
  }

  if (!options.binding.empty()) {
    const BindingRequest request{options.binding, options.count_given, !options.splits.empty(),
                                 !options.simulators.empty() || !options.scenes.empty()};
    const auto refused = apply_binding_request(request, reading.resources, options.configuration);
    if (!refused) return refuse(refused.error());
    std::printf("%s", refused->c_str());
    if (!refused->empty()) return Exit::Wrong;
  }

  return make_data_set(options, reading.resources, program);
}

}  // namespace

void add_generate_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<GenerateOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("generate", "Make a data set of your own design");
  command->explain(
      "Each task has a home, a start state, a goal formula, an instruction and a demonstration that was executed in "
      "physics and reaches the goal. The same options and seed give the same bytes for any number of threads. While "
      "the run is under way its work is in OUT.partial, which becomes OUT at the end.\n\n"
      "See `unietp help modes` and `unietp help homes`. Exit code 1: some tasks could not be made; the data set holds "
      "the others.",
      {{"unietp generate --count 40 --seed 1 --out out/first",
        "40 tasks, shared equally among the four simulators and the five splits"},
       {"unietp generate --count 20 --simulators ai2thor,habitat --splits logical --out out/logic", ""},
       {"unietp generate --count 8 --template place-one-on,slice-one --out out/two",
        "only these templates; `unietp template list` names all"},
       {"unietp generate --count 8 --templates my/templates --template sweep-one --out out/mine",
        "a template of your own, loaded beside the built-in ones"},
       {"unietp generate --template place-one-on --bind A=Book B=Sofa --out out/book",
        "exactly this task, or the reason why it cannot be made"},
       {"unietp generate --count 20 --scenes out/homes --out out/imported",
        "in the homes of these scene files, such as `unietp scene import` writes"},
       {"unietp generate --native --count 20 --scenes house.jsonl.gz --out out/native",
        "in a simulator's own scenes, only what that simulator can do (docs/native.md)"},
       {"unietp generate --count 20 --modes M1,M2,M3 --out out/modes", "demonstrated in all three modes"},
       {"unietp generate --count 40 --seed 1 --out out/first --resume",
        "continue after an interruption; the result is the same to the byte"}});
  auto& configuration = options->configuration;
  auto* count =
      command
          ->add_option("--count", configuration.count, "Number of tasks (default: 40; with --bind, one per simulator)")
          ->within(1, limits::kTasks);
  command->add_option("--seed", configuration.seed, "Seed of the run")->shows_default();
  add_simulators_option(*command, options->simulators, "Simulators (default: all)");
  command->add_option("--splits", options->splits, "Splits (default: all)")
      ->type_name("NAME,...")
      ->suggests(split_names());
  command->add_option("--modes", options->modes, "Keep tasks that are demonstrated in all of these (default: M1)")
      ->type_name("MODE,...")
      ->suggests({"M1", "M2", "M3"});
  command->add_option("--template", configuration.templates, "Templates by name (default: all)")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->one_each();
  add_library_options(*command, program);
  command->add_option("--bind", options->binding, "Categories for some or all placeholders of the one template")
      ->type_name("A=Mug B=Fridge ...");
  command->add_option("--attempts", configuration.attempts, "Candidates to try before a task is given up")
      ->within(1, limits::kAttempts)
      ->shows_default();
  command->add_option("--rooms", configuration.rooms, "Rooms in a home")->within(5, 20)->shows_default();
  command->add_option("--objects", configuration.objects, "Movable objects to ask for in a home")
      ->within(0, 1000)
      ->shows_default();
  command->add_option("--scenes,--scene", options->scenes,
                      "Homes to use: scene files, folders of them, or names of benchmark homes (default: new homes)");
  command->add_flag("--native", configuration.native,
                    "Only tasks that can be done in the simulator itself, in scenes of its own: --scenes takes the "
                    "simulators' files, too");
  command->add_option(
      "--assets", options->assets,
      "With --native: categories and sizes of models that scenes only name, as `scene import` takes them");
  add_run_options(*command, *options, program);
  command->callback([options, count, &program] {
    options->count_given = count->given();
    program.exit = generate(*options, program);
  });
}

}  // namespace unietp
