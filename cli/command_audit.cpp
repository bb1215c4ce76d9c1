#include <cstdio>
#include <memory>
#include <mutex>

#include "audit/audit.h"
#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/progress_line.h"

namespace unietp {
namespace {

struct AuditOptions {
  std::filesystem::path folder, training;
  int threads = 1;
  bool json = false, whole = false;
};

Exit run_audit(const AuditOptions& options, const CommandLine& program) {
  ProgressLine line(program.terminal);
  std::mutex drawing;
  const auto shows = [&](const char* what) {
    return [&line, &drawing, what](int count) {
      const std::scoped_lock lock(drawing);
      line.draw(std::to_string(count) + what);
    };
  };
  auto tasks = audited_tasks(options.folder, options.threads, shows(" tasks read"));
  if (!tasks) return refuse(tasks.error());
  std::vector<AuditedTask> training;
  if (!options.training.empty()) {
    auto examples = audited_tasks(options.training, options.threads, shows(" training tasks read"));
    if (!examples) return refuse(examples.error());
    training = std::move(*examples);
  }
  AuditSettings settings = whole_audit();
  settings.threads = options.threads;
  settings.progress = shows(" questions played");
  const auto report = audit(std::move(*tasks), std::move(training), settings);
  line.wipe();
  std::fputs((options.json ? audit_json(report) : audit_table(report, options.whole)).c_str(), stdout);
  return report.leaks() == 0 ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_audit_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<AuditOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("audit", "Look for shortcuts that give answers away");
  command->explain(
      "Plays blind policies against a finished data set. Each names an object, a room or a piece of furniture without "
      "doing the task: the last of the list, the lowest id of its kind, the only one in its state, what a classifier "
      "learned from other homes, and so on. A policy's chance is what it reaches on average when just what it tries to "
      "profit by is shuffled, 1000 times. `right %` above the range of chance is a leak when it stays improbable after "
      "Holm's correction for all cells.\n\n"
      "Policies that learn do so from the other homes of the set, or from a training set. Exit code 1: at least one "
      "policy is better than chance.",
      {{"unietp audit out/benchmark", ""},
       {"unietp audit out/benchmark --training out/training", "learn from these tasks"},
       {"unietp audit out/benchmark --whole", "all splits and simulators, not only those that leak"},
       {"unietp audit out/benchmark --json > audit.json", ""}});
  command->add_option("FOLDER", options->folder, "A finished data set")->required()->folder();
  command->add_option("--training", options->training, "A data set in other homes to learn from")->folder();
  command->add_flag("--whole", options->whole, "Print every split and simulator of each policy");
  add_threads_option(*command, options->threads, program);
  command->add_flag("--json", options->json, "Print JSON with all cells");
  command->callback([options, &program] { program.exit = run_audit(*options, program); });
}

}  // namespace unietp
