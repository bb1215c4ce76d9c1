#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "report/figure_table.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Figures of finished data sets: tasks, instructions, goals, plans, what became of the candidates, homes, balance.\n"
    "\n"
    "  unietp stats out/mine\n"
    "  unietp stats out/benchmark out/training          side by side\n"
    "  unietp stats out/mine --rows 200                 longer tables\n"
    "  unietp stats out/mine --json > figures.json\n"
    "\n"
    "`unietp report` shows the same with charts.";

struct Options {
  std::vector<std::filesystem::path> folders;
  int threads = 1, rows = 25;
  bool json = false;
};

Exit stats(const Options& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  std::vector<const Knowledge*> knowledge;
  for (const auto& backend : known.backends) knowledge.push_back(&backend.knowledge);
  std::vector<DatasetStatistics> sets;
  for (const auto& folder : options.folders) {
    const auto set = read_finished_set(folder);
    if (!set) return refuse(set.error());
    auto statistics = statistics_of_set(*set, knowledge, options.threads);
    if (!statistics) return refuse(statistics.error());
    sets.push_back(std::move(*statistics));
  }
  const std::string text =
      options.json ? statistics_json(sets) : table_text(tables_of(sets), static_cast<std::size_t>(options.rows));
  std::fputs(text.c_str(), stdout);
  return Exit::Ok;
}

}  // namespace

void add_stats_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  options->threads = program.processors;
  auto* command = app.add_subcommand("stats", kHelp);
  command->add_option("folders", options->folders, "Finished data sets")->required();
  command->add_option("--rows", options->rows, "Longest table")->within(1, 1000000);
  command->add_option("--threads", options->threads, "Threads (default: one a processor); never changes the result")
      ->within(1, 1024);
  command->add_flag("--json", options->json, "As JSON, with all rows");
  command->callback([options, &program] { program.exit = stats(*options, program); });
}

}  // namespace unietp
