#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "core/files.h"
#include "record/manifest_record.h"
#include "report/review_page.h"
#include "rewording/apply_review.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "Have people judge the tasks of a finished data set, and write it anew as they say.\n"
    "\n"
    "  unietp review out/mine --out review.html             a page to accept, reject or edit each task by\n"
    "  unietp review out/mine --apply review-mine.json      what the page saved; the folder is replaced at once\n"
    "  unietp review out/mine --apply review-mine.json --out out/reviewed\n"
    "\n"
    "The page is one file that needs nothing but a browser. Rejected tasks are taken out (--keep-rejected: only\n"
    "marked). An edit must pass the checks of instructions; one that does not is named with the reason, and its task\n"
    "stays as it was. Exit code 1: some verdicts were not taken over.";

struct Options {
  std::filesystem::path folder, out, reviews;
  ApplyOptions apply;
  int threads = 1, view = 256;
};

Exit write_page(const Options& options, const CommandLine& program) {
  if (options.out.empty()) return refuse({Error::Kind::Usage, "--out", {}, "say where to write the page"});
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  const auto set = read_finished_set(options.folder);
  if (!set) return refuse(set.error());
  const auto plans = plans_of(*set, options.threads);
  if (!plans) return refuse(plans.error());
  const auto pictures = [&](std::size_t i) -> Result<StartPictures> {
    const TaskRecord& task = set->tasks[i];
    const auto simulator = simulator_named(task.simulator);
    if (!simulator) return Error{Error::Kind::Schema, task.id, {}, "names an unknown simulator"};
    return pictures_of(*set, task, known.backends[static_cast<std::size_t>(*simulator)].profile, options.view);
  };
  const auto page = review_page(*set, *plans, options.threads, pictures);
  if (!page) return refuse(page.error());
  if (const auto written = write_file(options.out, *page); !written) return refuse(written.error());
  std::printf("%s: %zu tasks, %.1f MB\n", options.out.string().c_str(), set->tasks.size(),
              static_cast<double>(page->size()) / 1e6);
  return Exit::Ok;
}

Exit apply(const Options& options, const CommandLine& program) {
  const auto text = read_file(options.reviews);
  if (!text) return refuse(text.error());
  const auto reviews = read_reviews(options.reviews.string(), *text);
  if (!reviews) return refuse(reviews.error());
  auto folders = program.folders;
  folders.extended_library = records_extended_library(options.folder);
  const auto reading = load_resources(folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  ApplyOptions settings = options.apply;
  settings.licences = folders.licences();
  const auto report = apply_review(options.folder, options.out.empty() ? options.folder : options.out, *reviews,
                                   reading.resources, settings);
  if (!report) return refuse(report.error());
  for (const auto& [task, why] : report->refused) std::printf("%s: not taken over: %s\n", task.c_str(), why.c_str());
  std::printf("%d accepted, %d rejected, %d edited, %zu not taken over\n", report->accepted, report->rejected,
              report->edited, report->refused.size());
  return report->refused.empty() ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_review_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callback below outlives this function
  options->threads = program.processors;
  auto* command = app.add_subcommand("review", kHelp);
  command->add_option("folder", options->folder, "A finished data set")->required()->existing_folder();
  command->add_option("--out", options->out, "The page to write; with --apply, a new folder in place of this one");
  auto* reviews = command->add_option("--apply", options->reviews, "A file that the page saved")->existing_file();
  command->add_option("--view", options->view, "Pixels that the agent's view is wide in the page")
      ->within(16, 4096)
      ->shows_default();
  command
      ->add_flag("--accept-unchecked", options->apply.accept_unchecked,
                 "Take edits that do not pass the checks, too; the task's record says so")
      ->needs(reviews);
  command->add_flag("--keep-rejected", options->apply.keep_rejected, "Mark rejected tasks in reviews.jsonl only")
      ->needs(reviews);
  command->add_option("--threads", options->threads, "Threads (default: one a processor); never changes the result")
      ->within(1, 1024);
  command->callback([options, &program] {
    program.exit = options->reviews.empty() ? write_page(*options, program) : apply(*options, program);
  });
}

}  // namespace unietp
