#include <cstdio>
#include <memory>

#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "core/file_writer.h"
#include "core/files.h"
#include "core/limits.h"
#include "record/manifest_record.h"
#include "report/review_page.h"
#include "rewording/apply_review.h"

namespace unietp {
namespace {

struct ReviewOptions {
  std::filesystem::path folder, out, reviews;
  ApplyOptions apply;
  int threads = 1, view = 256;
};

Exit write_page(const ReviewOptions& options, const CommandLine& program) {
  if (options.out.empty()) return refuse({Error::Kind::Usage, "--out", {}, "expected a file to write the page to"});
  if (const auto writable = check_writable(options.out); !writable) return refuse(writable.error());
  const auto known = load_backends(program.folders);
  if (!known.errors.empty()) return refuse(known.errors);
  const auto set = read_finished_set(options.folder);
  if (!set) return refuse(set.error());
  const auto list = read_review_list(*set, options.threads);
  if (!list) return refuse(list.error());
  const auto tasks = shown_tasks(*set);
  if (!tasks) return refuse(tasks.error());
  const auto pictures = [&](const TaskRecord& task) -> Result<StartPictures> {
    const auto simulator = simulator_named(task.simulator);
    if (!simulator) return Error{Error::Kind::Schema, task.id, {}, "names an unknown simulator"};
    return pictures_of(*set, task, known.backends[static_cast<std::size_t>(*simulator)].profile, options.view);
  };
  const auto page = review_page(*set, *list, *tasks, options.threads, pictures);
  if (!page) return refuse(page.error());
  if (const auto written = write_file(options.out, *page); !written) return refuse(written.error());
  std::printf("%s: %zu tasks, %.1f MB\n", options.out.string().c_str(), list->size(),
              static_cast<double>(page->size()) / 1e6);
  return Exit::Ok;
}

Exit apply(const ReviewOptions& options, const CommandLine& program) {
  const auto text = read_file(options.reviews);
  if (!text) return refuse(text.error());
  const auto reviews = read_reviews(options.reviews.string(), *text);
  if (!reviews) return refuse(reviews.error());
  auto folders = program.folders;
  folders.extended_library = records_extended_library(options.folder);
  const auto reading = load_resources(folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  ApplyOptions settings = options.apply;
  settings.licenses = folders.licenses();
  const auto report = apply_review(options.folder, options.out.empty() ? options.folder : options.out, *reviews,
                                   reading.resources, settings);
  if (!report) return refuse(report.error());
  for (const auto& [task, why] : report->refused) std::printf("%s: not applied: %s\n", task.c_str(), why.c_str());
  std::printf("%d accepted, %d rejected, %d edited, %zu not applied\n", report->accepted, report->rejected,
              report->edited, report->refused.size());
  return report->refused.empty() ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_review_command(CommandParser& app, CommandLine& program) {
  auto options = std::make_shared<ReviewOptions>();  // shared: the callback outlives this function
  auto* command = app.add_subcommand("review", "Have people accept, reject or edit tasks, and apply their verdicts");
  command->explain(
      "The page is one file that needs only a browser. Applying its saved file removes rejected tasks and takes over "
      "edited instructions. An edit must pass the checks that all instructions pass; otherwise it is listed with the "
      "reason and the task stays as it was. The data set is replaced in one step. Exit code 1: some verdicts were not "
      "applied.",
      {{"unietp review out/mine --out review.html", "a page to accept, reject or edit each task"},
       {"unietp review out/mine --apply review-mine.json", "apply what the page saved"},
       {"unietp review out/mine --apply review-mine.json --out out/reviewed", ""}});
  command->add_option("FOLDER", options->folder, "A finished data set")->required()->folder();
  command->add_option("--out", options->out, "HTML file to write; with --apply, a new data set to make")->output();
  auto* reviews = command->add_option("--apply", options->reviews, "File that the page saved")->existing_file();
  command->add_option("--view", options->view, "Width of the agent's view on the page, in pixels")
      ->within(limits::kLeastImageSide, limits::kImageSide)
      ->shows_default();
  command
      ->add_flag("--accept-unchecked", options->apply.accept_unchecked,
                 "Also take edits that fail the checks; the task's record says so, and validate reports it")
      ->needs(reviews);
  command->add_flag("--keep-rejected", options->apply.keep_rejected, "Only mark rejected tasks in reviews.jsonl")
      ->needs(reviews);
  add_threads_option(*command, options->threads, program);
  command->callback([options, &program] {
    program.exit = options->reviews.empty() ? write_page(*options, program) : apply(*options, program);
  });
}

}  // namespace unietp
