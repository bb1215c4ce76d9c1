#include "cli/writer_options.h"

#include <cstdio>
#include <map>
#include <optional>

#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "cli/progress_line.h"
#include "core/unknown_name.h"
#include "dataset/configuration.h"
#include "llm/cache.h"
#include "rewording/annotate.h"
#include "rewording/batch_folder.h"

namespace unietp {
namespace {

Error option_error(std::string where, std::string message) {
  return {Error::Kind::Usage, std::move(where), {}, std::move(message)};
}

std::vector<LlmRequest> with_parameters(std::vector<LlmRequest> requests, const LlmChoice& llm) {
  for (LlmRequest& request : requests) {
    if (llm.temperature >= 0) request.temperature = llm.temperature;
    if (llm.max_tokens > 0) request.max_tokens = llm.max_tokens;
  }
  return requests;
}

void print_report(const AnnotateReport& report) {
  print_line(std::to_string(report.tasks) + " instructions");
  for (const auto& [writer, count] : report.by_writer) print_line("  " + std::to_string(count) + " by " + writer);
  for (const auto& [why, stand_ins] : report.stand_ins)
    print_line("  the grammar wrote " + std::to_string(stand_ins.tasks) + " instead (" + stand_ins.first + "): " + why);
  for (const auto& [wordings, tasks] : report.pairs.tasks_by_wordings)
    print_line("  " + std::to_string(tasks) + " tasks with " + std::to_string(wordings) +
               (wordings == 1 ? " wording" : " wordings") + " of their goal");
  if (report.pairs.contrasts > 0)
    print_line("  " + std::to_string(report.pairs.contrasts) + " tasks with a contrast, which asks for another goal");
  if (report.by_people > 0)
    print_line("  " + std::to_string(report.by_people) + " by people, kept; --replace-human replaces them");
}

/// Says why nothing was written.
void print_unwritten(const AnnotateReport& report, const std::filesystem::path& out, const std::string& how_to_go_on) {
  (void)std::fprintf(stderr,
                     "%s: left as it was, since %d requests have no answer (%s); %s, or take the grammar's "
                     "texts for the rest with --stand-in\n",
                     out.string().c_str(), report.unanswered, report.no_answer.c_str(), how_to_go_on.c_str());
}

Exit dry_run(const std::filesystem::path& folder, const Resources& resources, const AnnotateOptions& options,
             const LlmChoice& llm) {
  std::size_t count = 0;
  const auto printed = prompts_for(folder, resources, options, [&](const std::vector<LlmRequest>& requests) {
    for (const auto& request : with_parameters(requests, llm)) print_line(display_text(request));
    count += requests.size();
  });
  if (!printed) return refuse(printed.error());
  print_line(std::to_string(count) + " requests, then one for each text that passes the word checks; nothing was sent");
  return Exit::Ok;
}

Exit with_server(const RewordRequest& request, const Resources& resources, AnnotateOptions options,
                 const LlmChoice& llm, const CommandLine& program) {
  const auto url = chat_url(llm.url);
  if (!url) return refuse(url.error());
  const LlmEndpoint endpoint{*url, llm.model, program.llm_key};
  auto cache = LlmCache::open(llm.cache.empty() ? program.folders.cache / "llm-answers.sqlite" : llm.cache);
  if (!cache) return refuse(cache.error());
  ProgressLine progress(program.terminal);
  LlmTotals totals;
  std::size_t answered = 0;
  options.llm.ask = [&](const std::vector<LlmRequest>& requests) {
    LlmOptions asking = llm.ask;
    asking.stop = program.interrupted;
    asking.on_answer = [&](std::size_t, const Result<LlmAnswer>&) {
      progress.draw(std::to_string(++answered) + " answers");
    };
    auto answers = ask_all(endpoint, with_parameters(requests, llm), asking, &*cache);
    const auto now = totals_of(answers);
    totals.asked += now.asked, totals.cached += now.cached, totals.failed += now.failed;
    totals.prompt_tokens += now.prompt_tokens, totals.completion_tokens += now.completion_tokens;
    return answers;
  };
  const auto report = annotate_dataset(request.folder, request.out, resources, options);
  progress.wipe();
  if (!report) return refuse(report.error());
  if (cache->failure()) (void)refuse(*cache->failure());
  if (report->written) {
    print_report(*report);
  } else {
    print_unwritten(*report, request.out, "run the same command again: it asks only for what is missing");
  }
  print_line("requests   " + std::to_string(totals.asked) + " asked, " + std::to_string(totals.cached) +
             " from the cache, " + std::to_string(totals.failed) + " without an answer");
  print_line(cost_line(totals, llm.price));
  if (program.interrupted != nullptr && program.interrupted->load()) return Exit::Interrupted;
  return totals.failed == 0 && !cache->failure() ? Exit::Ok : Exit::Wrong;
}

Exit with_batch(const RewordRequest& request, const Resources& resources, AnnotateOptions options,
                const WriterChoice& choice) {
  auto batch = BatchFolder::open(choice.batch, choice.llm.model);
  if (!batch) return refuse(batch.error());
  options.llm.ask = [&](const std::vector<LlmRequest>& requests) {
    return batch->ask(with_parameters(requests, choice.llm));
  };
  const auto report = annotate_dataset(request.folder, request.out, resources, options);
  if (!report) return refuse(report.error());
  const auto left = batch->finish();
  if (!left) return refuse(left.error());
  if (report->written) {
    print_report(*report);
  } else {
    print_unwritten(*report, request.out, "send the request files, put the answers beside them and run this again");
  }
  print_line("batch      " + std::to_string(left->answered) + " answered, " + std::to_string(left->waiting) +
             " waiting, " + std::to_string(left->failed.size()) + " failed, " + std::to_string(left->new_requests) +
             " new requests");
  std::map<std::string, int> reasons;
  for (const auto& reason : left->failed) ++reasons[reason];
  for (const auto& [reason, count] : reasons) print_line("  " + std::to_string(count) + " failed: " + reason);
  for (const auto& file : left->new_files) print_line("  to send: " + file.string());
  if (left->new_requests + left->waiting > 0)
    print_line("put the service's answers into " + choice.batch.string() + " and run annotate again to continue");
  if (!left->unreadable.empty()) (void)refuse(left->unreadable);
  return left->waiting + left->new_requests == 0 && left->unreadable.empty() ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_writer_options(CommandParser& command, WriterChoice& choice) {
  command.add_option("--writer", choice.writer, "Who writes instructions: grammar, llm or batch")
      ->type_name("NAME")
      ->suggests({"grammar", "llm", "batch"})
      ->shows_default();
  command
      .add_option("--phrasings", choice.phrasings,
                  "Sentences that the grammar writes: everyday, or all, a wider choice; training and benchmark are two "
                  "halves of it that have no sentence pattern in common")
      ->type_name("NAME")
      ->suggests({"everyday", "all", "training", "benchmark"})
      ->shows_default();
  command
      .add_option("--english", choice.english,
                  "Names of things: us (fridge, trash can, faucet) or gb (fridge, bin, tap); default: us, or what the "
                  "data set has")
      ->type_name("NAME")
      ->suggests({"us", "gb"});
  command.add_option("--batch", choice.batch, "Folder of request and answer files, for --writer batch")
      ->folder()
      ->output();
  command.add_option("--rewrites", choice.rewrites, "Further attempts after a model's text was refused")
      ->within(0, 20)
      ->shows_default();
  command.add_flag("--stand-in", choice.stand_in,
                   "Where no answer came, take the grammar's text; otherwise nothing is changed then");
  add_llm_options(command, choice.llm, false);
}

Result<Phrasings> check_writer(const WriterChoice& choice) {
  const auto writer = writer_named(choice.writer);
  if (!writer) return unknown_name_error("--writer", choice.writer, {"grammar", "llm", "batch"});
  if (*writer == Writer::Llm && choice.llm.url.empty())
    return option_error("--writer llm", "needs --llm-url, the address of an OpenAI-compatible server");
  if (*writer != Writer::Grammar && choice.llm.model.empty())
    return option_error("--writer " + choice.writer, "needs --llm-model, as the server names it");
  if (*writer == Writer::Batch && choice.batch.empty())
    return option_error("--writer batch", "needs --batch, the folder for request and answer files");
  if (!choice.english.empty() && !english_of(choice))
    return unknown_name_error("--english", choice.english, {"us", "gb"});
  if (const auto phrasings = phrasings_named(choice.phrasings)) return *phrasings;
  return unknown_name_error("--phrasings", choice.phrasings, {"everyday", "all", "training", "benchmark"});
}

std::optional<English> english_of(const WriterChoice& choice) {
  for (const English english : kEnglishes)
    if (choice.english == name_of(english)) return english;
  return std::nullopt;
}

Exit reword_dataset(const RewordRequest& request, const Resources& resources, const WriterChoice& choice,
                    const CommandLine& program) {
  const auto phrasings = check_writer(choice);
  if (!phrasings) return refuse(phrasings.error());
  AnnotateOptions options;
  options.writer = *writer_named(choice.writer);
  options.seed = request.seed;
  options.paired = request.paired || request.contrasts || request.wordings > 0;
  if (request.wordings > 0) options.wordings = static_cast<std::size_t>(request.wordings);
  options.contrasts = request.contrasts;
  options.replace_human = request.replace_human;
  options.stand_in = choice.stand_in;
  options.llm.model = choice.llm.model;
  options.llm.rewrites = choice.rewrites;
  options.llm.phrasings = *phrasings;
  options.english = english_of(choice);
  if (choice.llm.dry_run) return dry_run(request.folder, resources, options, choice.llm);
  if (options.writer == Writer::Llm) return with_server(request, resources, options, choice.llm, program);
  if (options.writer == Writer::Batch) return with_batch(request, resources, options, choice);
  const auto report = annotate_dataset(request.folder, request.out, resources, options);
  if (!report) return refuse(report.error());
  print_report(*report);
  return Exit::Ok;
}

}  // namespace unietp
