#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "core/files.h"
#include "report/report_page.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Show a finished data set on one page that needs nothing but a browser: charts with the tables behind them, and\n"
    "examples with pictures.\n"
    "\n"
    "  unietp report out/mine --out report.html\n"
    "\n"
    "`unietp stats` prints the same figures; `unietp review` makes a page to judge each task by.";

struct Options {
  std::filesystem::path folder, out;
  int threads = 1, examples = 20;
};

Result<std::vector<ReportExample>> examples_of(const FinishedSet& set, const std::vector<Backend>& backends,
                                               const Options& options) {
  const auto plans = plans_of(set, options.threads);
  if (!plans) return plans.error();
  std::vector<ReportExample> examples;
  for (const std::size_t i : example_tasks(set, static_cast<std::size_t>(options.examples))) {
    const TaskRecord& task = set.tasks[i];
    const auto simulator = simulator_named(task.simulator);
    if (!simulator) return Error{Error::Kind::Schema, task.id, {}, "names an unknown simulator"};
    const Profile& profile = backends[static_cast<std::size_t>(*simulator)].profile;
    auto pictures = pictures_of(set, task, profile, profile.image_width);
    if (!pictures) return pictures.error();
    examples.push_back({&task, (*plans)[i], std::move(*pictures)});
  }
  return examples;
}

Exit report(const Options& options, const CommandLine& program) {
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  std::vector<const Knowledge*> knowledge;
  for (const auto& backend : known.backends) knowledge.push_back(&backend.knowledge);
  const auto set = read_finished_set(options.folder);
  if (!set) return refuse(set.error());
  const auto statistics = statistics_of_set(*set, knowledge, options.threads);
  if (!statistics) return refuse(statistics.error());
  const auto examples = examples_of(*set, known.backends, options);
  if (!examples) return refuse(examples.error());
  const std::string page = report_page(*statistics, *examples);
  if (const auto written = write_file(options.out, page); !written) return refuse(written.error());
  std::printf("%s: %zu examples, %.1f MB\n", options.out.string().c_str(), examples->size(),
              static_cast<double>(page.size()) / 1e6);
  return Exit::Ok;
}

}  // namespace

void add_report_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  options->threads = program.processors;
  auto* command = app.add_subcommand("report", kHelp);
  command->add_option("folder", options->folder, "A finished data set")->required();
  command->add_option("--out", options->out, "The page to write")->required();
  command->add_option("--examples", options->examples, "Tasks to show")->within(0, 1000)->shows_default();
  command->add_option("--threads", options->threads, "Threads (default: one a processor); never changes the result")
      ->within(1, 1024);
  command->callback([options, &program] { program.exit = report(*options, program); });
}

}  // namespace unietp
