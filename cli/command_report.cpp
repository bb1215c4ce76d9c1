#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "core/file_writer.h"
#include "core/files.h"
#include "report/report_page.h"

namespace unietp {
namespace {

struct ReportOptions {
  std::filesystem::path folder, out;
  int threads = 1, examples = 20;
};

Result<std::vector<ReportExample>> examples_of(const FinishedSet& set, const DatasetStatistics& statistics,
                                               const std::vector<Backend>& backends, const ReportOptions& options) {
  std::vector<ReportExample> examples;
  const auto places = example_places(statistics, static_cast<std::size_t>(options.examples));
  if (places.empty()) return examples;
  auto tasks = read_examples(set, places, options.threads);
  if (!tasks) return tasks.error();
  for (ShownTask& task : *tasks) {
    const auto simulator = simulator_named(task.record.simulator);
    if (!simulator) return Error{Error::Kind::Schema, task.record.id, {}, "names an unknown simulator"};
    const Profile& profile = backends[static_cast<std::size_t>(*simulator)].profile;
    auto pictures = pictures_of(set, task.record, profile, profile.image_width);
    if (!pictures) return pictures.error();
    examples.push_back({std::move(task), std::move(*pictures)});
  }
  return examples;
}

Exit report(const ReportOptions& options, const CommandLine& program) {
  if (const auto writable = check_writable(options.out); !writable) return refuse(writable.error());
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  std::vector<const Knowledge*> knowledge;
  for (const auto& backend : known.backends) knowledge.push_back(&backend.knowledge);
  const auto set = read_finished_set(options.folder);
  if (!set) return refuse(set.error());
  const auto statistics = statistics_of_set(*set, knowledge, options.threads);
  if (!statistics) return refuse(statistics.error());
  const auto examples = examples_of(*set, *statistics, known.backends, options);
  if (!examples) return refuse(examples.error());
  const std::string page = report_page(*statistics, *examples);
  if (const auto written = write_file(options.out, page); !written) return refuse(written.error());
  std::printf("%s: %zu examples, %.1f MB\n", options.out.string().c_str(), examples->size(),
              static_cast<double>(page.size()) / 1e6);
  return Exit::Ok;
}

}  // namespace

void add_report_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<ReportOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("report", "Write a web page with charts and example tasks");
  command->explain(
      "The page is one file that needs only a browser. `unietp stats` prints the same numbers; `unietp "
      "review` makes a page on which people judge each task.",
      {{"unietp report out/mine --out report.html", ""}});
  command->add_option("FOLDER", options->folder, "A finished data set")->required()->folder();
  command->add_option("--out", options->out, "HTML file to write")->required()->output();
  command->add_option("--examples", options->examples, "Number of example tasks")->within(0, 1000)->shows_default();
  add_threads_option(*command, options->threads, program);
  command->callback([options, &program] { program.exit = report(*options, program); });
}

}  // namespace unietp
