#include <algorithm>
#include <cstdio>
#include <memory>

#include "authoring/settle_binding.h"
#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/library_options.h"
#include "cli/run_command.h"
#include "homes/given_scenes.h"

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
    "  unietp generate --count 20 --writer llm --llm-url URL --llm-model M --out out/worded\n"
    "      instructions by a language model, in place of the grammar's when the tasks are made; see annotate\n"
    "  unietp generate --count 40 --seed 1 --out out/first --resume\n"
    "      go on after an interruption; the result is the same to the byte\n"
    "\n"
    "The same options and seed give the same bytes with any number of threads. Work is kept in OUT.partial and "
    "becomes\n"
    "OUT at the end. Exit code 1: some tasks could not be made; the data set holds the others.";

struct Options : RunCommand {
  std::string simulators, splits, modes;
  WriterChoice writer;
  std::vector<std::string> binding;
  bool count_given = false;
  std::vector<std::filesystem::path> scenes;
};

std::vector<Simulator> simulators_of(const std::vector<Scene>& scenes) {
  std::vector<Simulator> found;
  for (const auto simulator : kSimulators) {
    const auto own = [&](const Scene& scene) { return scene.simulator == simulator; };
    if (std::any_of(scenes.begin(), scenes.end(), own)) found.push_back(simulator);
  }
  return found;
}

Exit generate(Options& options, const CommandLine& program) {
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

  return make_data_set(options, reading.resources, program);
}

}  // namespace

void add_generate_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("generate", kHelp);
  auto& configuration = options->configuration;
  auto* count =
      command->add_option("--count", configuration.count, "How many tasks (default: 40; with --bind one a simulator)")
          ->within(1, 1000000);
  command->add_option("--seed", configuration.seed, "Number that names the run");
  command->add_option("--simulators", options->simulators, "Of ai2thor,virtualhome,habitat,behavior (default: all)");
  command->add_option("--splits", options->splits,
                      "Of atomic,compositional,logical,instance_grounding,linguistic (default: all)");
  command->add_option("--modes", options->modes,
                      "Of M1,M2,M3: each task is demonstrated in all of them, or given up (default: M1, always made)");
  command->add_option("--template", configuration.templates, "Names, as `unietp template list` shows (default: all)")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->one_each();
  add_library_options(*command, program);
  command
      ->add_option("--bind", options->binding,
                   "Categories for some or all placeholders of the one template: A=Mug B=Fridge")
      ->type_name("A=Mug ...");
  command->add_option("--attempts", configuration.attempts, "Candidates tried for one task before it is given up")
      ->within(1, 1024);
  command->add_option("--rooms", configuration.rooms, "Rooms of a home")->within(5, 20);
  command->add_option("--objects", configuration.objects, "Movable objects asked for in a home")->within(0, 1000);
  command->add_option("--scenes,--scene", options->scenes,
                      "Scene files, folders of them, or homes of the benchmark by name, in place of drawn homes");
  add_run_options(*command, *options, program);
  command->callback([options, count, &program] {
    options->count_given = count->given();
    program.exit = generate(*options, program);
  });
}

}  // namespace unietp
