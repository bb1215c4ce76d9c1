#include <memory>

#include "cli/command_parser.h"
#include "cli/run_command.h"

namespace unietp {
namespace {

struct BenchmarkOptions : RunCommand {
  std::filesystem::path file;
  std::optional<std::uint64_t> seed;
};

Exit make(BenchmarkOptions& options, CommandLine& program) {
  const auto usual = program.folders.runs() / "benchmark.json";
  auto configuration = settings_in(options.file.empty() ? usual : options.file, program);
  if (!configuration) return refuse(configuration.error());
  options.configuration = std::move(*configuration);
  if (options.seed) options.configuration.seed = *options.seed;
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  return make_data_set(options, reading.resources, program);
}

}  // namespace

void add_benchmark_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<BenchmarkOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("benchmark", "Make the benchmark: 536 tasks in 170 fixed homes");
  command->explain(
      "The tasks are divided among five splits and four simulators as published. The same configuration and seed give "
      "the same bytes for any number of threads. Exit code 1: some tasks could not be made.",
      {{"unietp benchmark --out out/benchmark", ""},
       {"unietp benchmark --config my.json --out out/mine",
        "your own numbers of tasks; start from data/runs/benchmark.json (see `unietp help files`)"}});
  command->add_option("--config", options->file, "Configuration file (default: the published benchmark)")
      ->existing_file();
  command->add_option("--seed", options->seed, "Draw other tasks in the same homes");
  add_run_options(*command, *options, program);
  command->callback([options, &program] { program.exit = make(*options, program); });
}

}  // namespace unietp
