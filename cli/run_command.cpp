#include "cli/run_command.h"

#include <array>
#include <cstdio>
#include <memory>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <nlohmann/json.hpp>

#include "cli/command_parser.h"
#include "cli/common_options.h"
#include "cli/progress_line.h"
#include "cli/simulator_forms.h"
#include "core/limits.h"
#include "core/text.h"
#include "dataset/configuration_json.h"
#include "dataset/lines.h"
#include "generator/rejection.h"
#include "rewording/annotate.h"

namespace unietp {
namespace {

std::string run_progress(const RunProgress& now) {
  const double rate = now.seconds > 0 ? now.tasks_now / now.seconds : 0;
  const double yield = now.candidates > 0 ? 100.0 * now.tasks / now.candidates : 0;
  const auto left = rate > 0 ? clock_text((now.asked - now.tasks) / rate) : std::string("-:--");
  std::array<char, 128> text{};
  (void)std::snprintf(text.data(), text.size(), "%d of %d tasks  %d candidates  yield %.0f %%  %.2f tasks/s  %s left",
                      now.tasks, now.asked, now.candidates, yield, rate, left.c_str());
  return text.data();
}

nlohmann::ordered_json json_of(const RunReport& report, const RunCommand& command) {
  auto unfilled = nlohmann::ordered_json::array();
  for (const auto& slot : report.unfilled)
    unfilled.push_back(
        {{"slot", slot.slot}, {"what", slot.description}, {"last", slot.last ? line_of(*slot.last) : ""}});
  auto balance = nlohmann::ordered_json::array();
  for (const auto& spread : report.balance)
    balance.push_back({{"dimension", name_of(spread.dimension)},
                       {"values", spread.values},
                       {"effective", spread.effective},
                       {"variation", spread.variation}});
  return {{"format", "unietp-generation/1"}, {"out", command.run.out.string()}, {"interrupted", report.interrupted},
          {"tasks", report.tasks},           {"asked", report.asked},           {"candidates", report.candidates},
          {"seconds", report.seconds},       {"balance", std::move(balance)},   {"unfilled", std::move(unfilled)}};
}

/// "templates 59 (as 55.1 equally frequent ones), categories …"
std::string text_of(const std::vector<Spread>& balance) {
  std::vector<std::string> parts;
  for (const auto& spread : balance) {
    std::array<char, 96> text{};
    (void)std::snprintf(text.data(), text.size(), "%s: %d values, as balanced as %.1f equally frequent ones",
                        std::string(name_of(spread.dimension)).c_str(), spread.values, spread.effective);
    parts.emplace_back(text.data());
  }
  return join(parts, "; ");
}

/// "grounding no-free-place: …; there is no space left: …"
std::string reason_text(const RejectionEntry& rejection) {
  const auto known = rejection_reason_named(rejection.reason);
  const std::string hint(known ? hint_for(*known) : "");
  return rejection.stage + " " + rejection.reason + ": " + rejection.detail + (hint.empty() ? "" : "; " + hint);
}

Exit print_report(const RunReport& report, const RunCommand& command, spdlog::logger& log) {
  const auto out = command.run.out.string();
  if (command.json) std::printf("%s\n", json_of(report, command).dump(2).c_str());
  if (report.interrupted) {
    log.warn("interrupted with {} of {} tasks; run the same command with --resume to continue", report.tasks,
             report.asked);
    return Exit::Interrupted;
  }
  if (!command.json)
    std::printf("%d of %d tasks in %s (%d candidates, %s)\n", report.tasks, report.asked, out.c_str(),
                report.candidates, clock_text(report.seconds).c_str());
  if (!command.json && report.tasks > 1) std::printf("balance: %s\n", text_of(report.balance).c_str());
  for (const auto& slot : report.unfilled)
    log.error("no {} after {} attempts; the last: {}", slot.description, command.configuration.attempts,
              slot.last ? reason_text(*slot.last) : "");
  return report.unfilled.empty() ? Exit::Ok : Exit::Wrong;
}

}  // namespace

Result<RunConfiguration> settings_in(const std::filesystem::path& file, CommandLine& program) {
  auto configuration = read_configuration(file);
  if (!configuration) return configuration.error();
  if (!configuration->scenes.empty() || configuration->native || !configuration->own.empty() ||
      !configuration->binding.empty())
    return Error{Error::Kind::Usage,
                 file.string(),
                 {},
                 "has scenes, `native`, a binding or your own templates; give these to `unietp generate` as options"};
  program.folders.extended_library = configuration->extended;
  return configuration;
}

void add_run_options(CommandParser& app, RunCommand& command, const CommandLine& program) {
  add_threads_option(app, command.run.threads, program);
  app.add_option("--out", command.run.out, "Folder to make")->required()->folder()->output();
  app.add_flag("--resume", command.run.resume, "Continue the unfinished run in OUT.partial");
  app.add_option("--ledger", command.run.ledger,
                 "Keep the record of all candidates, with stage, reason and cost, in this SQLite file")
      ->output();
  app.add_option("--shard", command.shard, "Make only part K of N; `unietp merge` joins the parts")->type_name("K/N");
  app.add_option("--sense", command.sense,
                 "How much sense tasks must make: usual (default), tolerable or any (docs/sense.md)")
      ->type_name("GRADE")
      ->suggests({"usual", "tolerable", "any"});
  add_writer_options(app, command.writer);
  app.add_flag("--json", command.json, "Print the report as JSON");
}

Exit make_data_set(RunCommand& command, const Resources& resources, const CommandLine& program) {
  spdlog::logger log("unietp", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  log.set_pattern("%l: %v");
  if (command.configuration.seed > limits::kSeed)
    return refuse(
        {Error::Kind::Usage, "--seed", {}, "expected a whole number from 0 to " + std::to_string(limits::kSeed)});
  if (!command.sense.empty()) {
    const auto sense = parse_sense("--sense", command.sense);
    if (!sense) return refuse(sense.error());
    command.configuration.sense = *sense;
  }
  if (!command.shard.empty()) {
    const auto shard = parse_shard(command.shard);
    if (!shard) return refuse(shard.error());
    command.run.shard = *shard;
  }
  const auto phrasings = check_writer(command.writer);
  if (!phrasings) return refuse(phrasings.error());
  if (*phrasings != Phrasings::Everyday) command.configuration.phrasings = *phrasings;
  command.configuration.english = english_of(command.writer).value_or(command.configuration.english);
  const bool by_grammar = writer_named(command.writer.writer) == Writer::Grammar;
  if (!by_grammar && !command.run.shard.is_whole())
    return refuse({Error::Kind::Usage,
                   "--writer",
                   {},
                   "a shard's instructions are written by the grammar; run `unietp annotate` on the merged data set"});
  ProgressLine line(program.terminal);
  command.run.licenses = program.folders.licenses();
  command.run.stop = program.interrupted;
  if (program.terminal) command.run.progress = [&line](const RunProgress& now) { line.draw(run_progress(now)); };
  auto in_simulator = simulator_check(resources, program.folders);
  if (!in_simulator) return refuse(in_simulator.error());
  command.run.in_simulator = std::move(*in_simulator);
  const auto report = run_generation(command.configuration, resources, command.run);
  line.wipe();
  if (!report) {
    const Exit refused = refuse(report.error());
    if (std::error_code code;
        report.error().kind == Error::Kind::Io && std::filesystem::exists(command.run.out.string() + ".partial", code))
      log.warn(
          "the work so far is kept; when the file can be written (is the disk full?), run the same command with "
          "--resume to continue");
    return refused;
  }
  const Exit made = print_report(*report, command, log);
  if (report->interrupted || by_grammar) return made;
  const auto& out = command.run.out;
  const Exit reworded = reword_dataset({out, out, {}}, resources, command.writer, program);
  return made == Exit::Ok ? reworded : made;
}

}  // namespace unietp
