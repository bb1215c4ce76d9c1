#include <algorithm>
#include <memory>

#include "cli/command_parser.h"
#include "cli/run_command.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Make training data: 9,000 tasks in homes that the benchmark does not have.\n"
    "\n"
    "  unietp training --out out/training\n"
    "  unietp training --count 500 --seed 7 --out out/small\n"
    "  unietp training --without-simulator ai2thor --out out/three\n"
    "      to see how far what was learnt carries over to a simulator that was never seen\n"
    "  unietp training --hold-out-templates --out out/two-thirds\n"
    "      without the third of the templates that data/runs/held_out_templates.txt names\n"
    "  unietp training --shard 2/8 --out out/part-2\n"
    "      one of eight parts, on one of eight machines; `unietp merge` puts them together\n"
    "\n"
    "The same options and seed give the same bytes with any number of threads and shards. Exit code 1: some tasks\n"
    "could not be made.";

struct Options : RunCommand {
  std::filesystem::path file;
  std::uint64_t seed = 0;
  int count = 0;
  bool seeded = false, counted = false, hold_out = false;
  std::string without_simulators;
};

/// A name a line; what follows # is a comment. Errors: Io.
Result<std::vector<std::string>> names_in(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text) return text.error();
  std::vector<std::string> names;
  for (const auto& line : split(*text, '\n')) {
    if (const auto name = trim(std::string_view(line).substr(0, line.find('#'))); !name.empty())
      names.emplace_back(name);
  }
  return names;
}

/// The configuration file's settings with what the options change.
Result<RunConfiguration> settings_of(const Options& options, CommandLine& program) {
  const DataFolders& folders = program.folders;
  auto configuration = settings_in(options.file.empty() ? folders.runs() / "training.json" : options.file, program);
  if (!configuration) return configuration.error();
  if (options.seeded) configuration->seed = options.seed;
  if ((options.counted || !options.without_simulators.empty()) && !configuration->quotas.empty())
    return Error{Error::Kind::Usage,
                 options.file.string(),
                 {},
                 "has quotas, which say how many tasks there are of each simulator; change the file instead"};
  if (options.counted) configuration->count = options.count;
  if (!options.without_simulators.empty()) {
    const auto left_out = parse_simulators("--without-simulator", options.without_simulators);
    if (!left_out) return left_out.error();
    std::erase_if(configuration->simulators, [&](Simulator simulator) {
      return std::find(left_out->begin(), left_out->end(), simulator) != left_out->end();
    });
    if (configuration->simulators.empty())
      return Error{Error::Kind::Usage, "--without-simulator", {}, "leaves no simulator"};
  }
  if (options.hold_out) {
    const auto names = names_in(folders.runs() / "held_out_templates.txt");
    if (!names) return names.error();
    configuration->without.insert(configuration->without.end(), names->begin(), names->end());
  }
  return configuration;
}

Exit make(Options& options, CommandLine& program) {
  auto configuration = settings_of(options, program);
  if (!configuration) return refuse(configuration.error());
  options.configuration = std::move(*configuration);
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  return make_data_set(options, reading.resources, program);
}

}  // namespace

void add_training_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("training", kHelp);
  command->add_option("--config", options->file, "Settings, in place of data/runs/training.json")->existing_file();
  auto* count = command->add_option("--count", options->count, "How many tasks (default: 9000)")->within(1, 1000000000);
  auto* seed = command->add_option("--seed", options->seed, "Number that names the run: other homes, other tasks");
  command->add_option("--without-simulator", options->without_simulators,
                      "Leave out one or more of ai2thor,virtualhome,habitat,behavior");
  command->add_flag("--hold-out-templates", options->hold_out,
                    "Leave out a fixed third of the templates, for tests on kinds of tasks that were never seen");
  add_run_options(*command, *options, program);
  command->callback([options, count, seed, &program] {
    options->counted = count->given();
    options->seeded = seed->given();
    program.exit = make(*options, program);
  });
}

}  // namespace unietp
