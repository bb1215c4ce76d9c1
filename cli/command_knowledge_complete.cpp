#include <memory>

#include <nlohmann/json.hpp>

#include "akb/complete.h"
#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "cli/llm_options.h"
#include "cli/progress_line.h"
#include "core/folder_lock.h"
#include "core/text.h"
#include "core/unknown_name.h"
#include "dataset/configuration.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct KnowledgeCompleteOptions {
  std::string simulator, facts;
  LlmChoice llm;
  int batch = 8, limit = 0;
  bool json = false;
};

Result<std::vector<FactKind>> parse_facts(const std::string& text) {
  std::vector<std::string> names;
  for (const auto kind : all_fact_kinds()) names.emplace_back(name_of(kind));
  std::vector<FactKind> facts;
  for (const auto& word : split(text, ',')) {
    const auto kind = fact_kind_named(trim(word));
    if (!kind) return unknown_name_error("--facts", trim(word), names);
    facts.push_back(*kind);
  }
  return facts;
}

/// "function 48, size 2"
std::string counts_text(const std::map<FactKind, int>& counts) {
  std::vector<std::string> parts;
  for (const auto& [kind, count] : counts) {
    if (count > 0) parts.push_back(std::string(name_of(kind)) + " " + std::to_string(count));
  }
  return parts.empty() ? "nothing" : join(parts, ", ");
}

Json counts_json(const std::map<FactKind, int>& counts) {
  Json json = Json::object();
  for (const auto& [kind, count] : counts) json[std::string(name_of(kind))] = count;
  return json;
}

/// Number and first example of a reason for rejection.
struct ReasonCount {
  int count = 0;
  std::string example;
};
std::map<std::string, ReasonCount> reasons_of(const std::vector<RejectedFact>& rejected) {
  std::map<std::string, ReasonCount> reasons;
  for (const auto& fact : rejected) {
    auto& reason = reasons[fact.reason];
    if (++reason.count == 1) reason.example = trim(fact.category + " " + fact.fact + " " + fact.value);
  }
  return reasons;
}

void print_report(const CompletionPlan& plan, const CompletionReport& report, const KnowledgeCompleteOptions& options) {
  const auto& totals = report.totals;
  print_line("lacking    " + counts_text(plan.lacking));
  print_line("completed before by a language model: " + counts_text(plan.completed));
  print_line("requests   " + std::to_string(totals.asked) + " asked, " + std::to_string(totals.cached) +
             " from the cache, " + std::to_string(totals.failed) + " without an answer");
  for (const auto& [reason, count] : report.failures) print_line("  " + std::to_string(count) + "  " + reason);
  print_line("accepted   " + counts_text(report.accepted));
  print_line("rejected   " + std::to_string(report.rejected.size()));
  for (const auto& [reason, found] : reasons_of(report.rejected))
    print_line("  " + std::to_string(found.count) + "  " + reason +
               (found.example.empty() ? "" : ": " + found.example));
  if (report.unused > 0)
    print_line("unused     " + std::to_string(report.unused) +
               " completed facts that another source already has, or whose name is ambiguous");
  print_line(cost_line(totals, options.llm.price));
}

Json json_of(const CompletionPlan& plan, const CompletionReport& report, const KnowledgeCompleteOptions& options) {
  const auto& totals = report.totals;
  Json rejected = Json::object();
  for (const auto& [reason, found] : reasons_of(report.rejected))
    rejected[reason] = {{"count", found.count}, {"example", found.example}};
  return {{"lacking", counts_json(plan.lacking)},
          {"completed_before", counts_json(plan.completed)},
          {"requests", {{"asked", totals.asked}, {"cached", totals.cached}, {"failed", totals.failed}}},
          {"failures", report.failures},
          {"accepted", counts_json(report.accepted)},
          {"rejected", rejected},
          {"unused", report.unused},
          {"tokens", {{"prompt", totals.prompt_tokens}, {"completion", totals.completion_tokens}}},
          {"cost", cost_of(totals, options.llm.price)},
          {"stopped", report.stopped}};
}

Exit complete(const KnowledgeCompleteOptions& options, const CommandLine& program) {
  const Result<std::vector<Simulator>> simulators = options.simulator.empty()
                                                        ? std::vector<Simulator>(kSimulators.begin(), kSimulators.end())
                                                        : parse_simulators("simulator", options.simulator);
  if (!simulators) return refuse(simulators.error());
  const auto facts = parse_facts(options.facts);
  if (!facts) return refuse(facts.error());
  const auto url = chat_url(options.llm.url);
  if (!url) return refuse(url.error());
  const LlmEndpoint endpoint{*url, options.llm.model, program.llm_key};
  const auto cache_file = options.llm.cache.empty() ? program.folders.cache / "llm-answers.sqlite" : options.llm.cache;
  auto cache = LlmCache::open(cache_file);
  if (!cache) return refuse(cache.error());

  CompletionOptions completion;
  completion.simulators = *simulators;
  completion.facts = *facts;
  completion.overrides = program.folders.overrides;
  completion.batch = options.batch;
  if (options.limit > 0) completion.limit = options.limit;
  completion.ask = options.llm.ask;
  completion.ask.stop = program.interrupted;
  if (options.llm.temperature >= 0) completion.temperature = options.llm.temperature;
  if (options.llm.max_tokens > 0) completion.max_tokens = options.llm.max_tokens;

  const auto lock =
      FolderLock::take(program.folders.tables() / "completed");  // read now, and written after each answer
  if (!lock) return refuse(lock.error());
  std::vector<Error> errors;
  auto plan = plan_completion(program.folders.tables(), endpoint, completion, &*cache, errors);
  if (!errors.empty()) return refuse(errors);
  if (options.llm.dry_run) {
    for (const auto& request : plan.requests) print_line(display_text(request));
    print_line(std::to_string(plan.requests.size()) + " requests; nothing was sent");
    return Exit::Ok;
  }
  ProgressLine progress(program.terminal && !options.json);
  std::size_t answered = 0;
  completion.ask.on_answer = [&](std::size_t, const Result<LlmAnswer>&) {
    progress.draw(std::to_string(++answered) + " of " + std::to_string(plan.requests.size()) + " requests");
  };
  const auto report = complete_knowledge(program.folders.tables(), endpoint, completion, &*cache, plan);
  progress.wipe();
  if (!report) return refuse(report.error());
  if (cache->failure()) (void)refuse(*cache->failure());
  if (options.json) {
    print_line(json_of(plan, *report, options).dump(2));
  } else {
    print_report(plan, *report, options);
  }
  if (report->stopped) return Exit::Interrupted;
  return report->failures.empty() && !cache->failure() ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_knowledge_complete_command(CommandParser& knowledge, CommandLine& program) {
  auto options = std::make_shared<KnowledgeCompleteOptions>();  // shared: the callback outlives this function
  options->facts = "size,mass,synset,aliases,function,context,placements,affordances";
  auto* command = knowledge.add_subcommand("complete", "Ask a language model for facts that the tables lack");
  command->explain(
      "Answers that pass every check go to data/akb/completed/ with the source llm:MODEL and the confidence 0.5. They "
      "count only where no other source has a fact of that kind. Answers are cached, so the same command asks nothing "
      "twice. See `unietp help models` for servers and keys.",
      {{"unietp knowledge complete ai2thor --llm-url http://localhost:8080/v1 --llm-model qwen2.5-7b", ""},
       {"unietp knowledge complete --llm-url URL --llm-model M --facts function,context --limit 20", ""},
       {"unietp knowledge complete --llm-url URL --llm-model M --dry-run", "print the prompts and send nothing"}});
  add_simulator_argument(*command, options->simulator, "The simulator (default: all)");
  add_llm_options(*command, options->llm, true);
  command->add_option("--facts", options->facts, "Kinds of facts, separated by commas")
      ->type_name("KIND,...")
      ->shows_default();
  command->add_option("--limit", options->limit, "Largest number of categories to ask about; cached ones do not count")
      ->within(1, 1'000'000);
  command->add_option("--batch", options->batch, "Categories per request")->within(1, 100)->shows_default();
  command->add_flag("--json", options->json, "Print the result as JSON");
  command->callback([options, &program] { program.exit = complete(*options, program); });
}

}  // namespace unietp
