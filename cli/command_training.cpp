#include <algorithm>
#include <memory>

#include "cli/command_parser.h"
#include "cli/common_options.h"
#include "cli/held_out_templates.h"
#include "cli/run_command.h"
#include "core/limits.h"

namespace unietp {
namespace {

struct TrainingOptions : RunCommand {
  std::filesystem::path file;
  std::optional<std::uint64_t> seed;
  int count = 0;  // 0: not given
  bool hold_out = false;
  std::string without_simulators;
};

/// The settings of the configuration file, changed by the options.
Result<RunConfiguration> settings_of(const TrainingOptions& options, CommandLine& program) {
  const DataFolders& folders = program.folders;
  auto configuration = settings_in(options.file.empty() ? folders.runs() / "training.json" : options.file, program);
  if (!configuration) return configuration.error();
  if (options.seed) configuration->seed = *options.seed;
  if ((options.count > 0 || !options.without_simulators.empty()) && !configuration->quotas.empty())
    return Error{
        Error::Kind::Usage,
        options.file.string(),
        {},
        "has quotas, which fix the number of tasks per simulator; change the file instead of giving --count or "
        "--without-simulator"};
  if (options.count > 0) configuration->count = options.count;
  if (!options.without_simulators.empty()) {
    const auto left_out = parse_simulators("--without-simulator", options.without_simulators);
    if (!left_out) return left_out.error();
    std::erase_if(configuration->simulators, [&](Simulator simulator) {
      return std::find(left_out->begin(), left_out->end(), simulator) != left_out->end();
    });
    if (configuration->simulators.empty())
      return Error{Error::Kind::Usage, "--without-simulator", {}, "no simulator is left"};
  }
  if (options.hold_out) {
    const auto names = held_out_templates(folders);
    if (!names) return names.error();
    configuration->without.insert(configuration->without.end(), names->begin(), names->end());
  }
  return configuration;
}

Exit make(TrainingOptions& options, CommandLine& program) {
  auto configuration = settings_of(options, program);
  if (!configuration) return refuse(configuration.error());
  options.configuration = std::move(*configuration);
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  return make_data_set(options, reading.resources, program);
}

}  // namespace

void add_training_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<TrainingOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("training", "Make training data: 9,000 tasks in homes the benchmark does not use");
  command->explain(
      "Each task is demonstrated in modes M1 and M2. The same options and seed give the same bytes for any number of "
      "threads and shards. Exit code 1: some tasks could not be made. No demonstration has a mistake in it; "
      "`unietp export --format sft --mistakes RATE` puts some in, with their feedback and the recovery.",
      {{"unietp training --out out/training", ""},
       {"unietp training --count 500 --seed 7 --out out/small", ""},
       {"unietp training --without-simulator ai2thor --out out/three",
        "leave out one simulator, to test transfer to an unseen one"},
       {"unietp training --hold-out-templates --out out/two-thirds",
        "leave out a fixed third of the templates, to test on unseen kinds of tasks"},
       {"unietp training --shard 2/8 --out out/part-2",
        "the second of eight parts, each on a machine of its own; `unietp merge` joins them"}});
  command->add_option("--config", options->file, "Configuration file (default: the 9,000 tasks)")->existing_file();
  command->add_option("--count", options->count, "Number of tasks (default: 9000)")->within(1, limits::kTasks);
  command->add_option("--seed", options->seed, "Seed of the run: other homes, other tasks");
  add_simulators_option(*command, options->without_simulators, "Leave out one or more simulators",
                        "--without-simulator");
  command->add_flag("--hold-out-templates", options->hold_out,
                    "Leave out the templates that data/runs/held_out_templates.txt lists");
  add_run_options(*command, *options, program);
  command->callback([options, &program] { program.exit = make(*options, program); });
}

}  // namespace unietp
