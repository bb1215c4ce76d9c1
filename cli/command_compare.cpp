#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "core/files.h"
#include "core/staged_folder.h"
#include "scores/comparison.h"
#include "scores/evaluation_page.h"
#include "scores/result_tables.h"
#include "scores/table_cells.h"
#include "scores/write_results.h"

namespace unietp {
namespace {

struct CompareOptions {
  std::vector<std::filesystem::path> runs;
  std::filesystem::path out;
};

/// The URL of each run's report, as seen from a page in the folder; "" where there is none.
std::vector<std::string> reports_from(const std::filesystem::path& folder,
                                      const std::vector<std::filesystem::path>& runs) {
  std::vector<std::string> reports;
  for (const auto& run : runs) {
    std::error_code failed;
    const auto report = std::filesystem::relative(run / kReportFile, folder, failed);
    const bool is_there = !failed && std::filesystem::exists(run / kReportFile, failed);
    reports.push_back(is_there ? in_url(report.generic_string()) : "");
  }
  return reports;
}

Result<Done> write_comparison(const std::filesystem::path& folder, const std::vector<ScoredRun>& runs,
                              const std::vector<ResultTable>& tables, const std::vector<std::string>& reports) {
  auto staged = StagedFolder::begin(folder, false);
  if (!staged) return staged.error();
  const std::pair<const char*, std::string> files[] = {{"tables.md", to_markdown(tables)},
                                                       {"tables.tex", to_latex(tables)},
                                                       {"tables.csv", to_csv(tables)},
                                                       {"leaderboard.html", leaderboard_page(runs, reports)}};
  for (const auto& [name, text] : files) {
    if (auto done = write_file(staged->folder(), name, text); !done) return done;
  }
  return staged->finish();
}

Exit compare(const CompareOptions& options) {
  std::vector<ScoredRun> runs;
  for (const auto& folder : options.runs) {
    auto run = read_scored_run(folder);
    if (!run) return refuse(run.error());
    runs.push_back(std::move(*run));
  }
  if (const auto fine = check_comparable(runs); !fine) return refuse(fine.error());
  auto tables = comparison_tables(runs);
  for (ResultTable& table : result_tables(runs)) tables.push_back(std::move(table));
  if (!options.out.empty()) {
    if (const auto done = write_comparison(options.out, runs, tables, reports_from(options.out, options.runs)); !done)
      return refuse(done.error());
  }
  std::fputs(to_plain_text(tables).c_str(), stdout);
  for (const ScoredRun& run : runs) {
    if (!run.complete()) return Exit::Wrong;
  }
  return Exit::Ok;
}

}  // namespace

void add_compare_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<CompareOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("compare", "Put evaluations side by side, with tests of their differences");
  command->explain(
      "Prints the tables of all runs, their ranks, and for each pair whether they differ: by McNemar's exact test on "
      "the "
      "tasks that both finished or, with repeats, by a sign-flip test over homes; corrected for the number of pairs. "
      "Runs "
      "that cannot be told apart share their place. Runs on different data sets or versions of the benchmark are "
      "refused. "
      "Exit code 1: a run is incomplete.",
      {{"unietp compare out/model-a out/model-b", ""},
       {"unietp compare out/runs/* --out out/leaderboard",
        "also as leaderboard.html, tables.md, tables.tex, tables.csv"}});
  command->add_option("RUN", options->runs, "Folders that `unietp evaluate` wrote")->required()->folder();
  command->add_option("--out", options->out, "New folder for the tables and the page")->folder()->output();
  command->callback([options, &program] { program.exit = compare(*options); });
}

}  // namespace unietp
