#include <memory>

#include "cli/command_parser.h"
#include "cli/run_command.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Make the benchmark: 536 tasks in five splits, in 170 homes that never change.\n"
    "\n"
    "  unietp benchmark --out out/benchmark\n"
    "  unietp benchmark --config my.json --out out/mine\n"
    "      with quotas of your own; data/runs/benchmark.json is the usual file, docs/files.md explains its fields\n"
    "\n"
    "The same file and seed give the same bytes with any number of threads. Exit code 1: some tasks could not be made.";

struct Options : RunCommand {
  std::filesystem::path file;
  std::uint64_t seed = 0;
  bool seeded = false;
};

Exit make(Options& options, CommandLine& program) {
  const auto usual = program.folders.runs() / "benchmark.json";
  auto configuration = settings_in(options.file.empty() ? usual : options.file, program);
  if (!configuration) return refuse(configuration.error());
  options.configuration = std::move(*configuration);
  if (options.seeded) options.configuration.seed = options.seed;
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  return make_data_set(options, reading.resources, program);
}

}  // namespace

void add_benchmark_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  auto* command = app.add_subcommand("benchmark", kHelp);
  command->add_option("--config", options->file, "Quotas and options, in place of data/runs/benchmark.json")
      ->existing_file();
  auto* seed = command->add_option("--seed", options->seed, "Another draw of tasks, in the same homes");
  add_run_options(*command, *options, program);
  command->callback([options, seed, &program] {
    options->seeded = seed->given();
    program.exit = make(*options, program);
  });
}

}  // namespace unietp
