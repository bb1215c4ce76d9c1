#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "authoring/coverage.h"
#include "authoring/expert_success.h"
#include "authoring/mode_success.h"
#include "authoring/trial_reasons.h"
#include "cli/command_parser.h"
#include "cli/command_template.h"
#include "cli/common_options.h"
#include "cli/each_home.h"
#include "cli/library_options.h"
#include "core/limits.h"
#include "core/text.h"
#include "core/unknown_name.h"

namespace unietp {
namespace {

struct TemplateCoverageOptions {
  std::vector<std::string> names;
  std::string simulators;
  std::string modes = "M1";
  std::uint64_t seed = 1;
  int tries = 0, homes = 6, threads = 1;
  bool json = false, markdown = false;
};

using Json = nlohmann::ordered_json;

Json json_of(const CoverageCell& cell) {
  auto reasons = Json::array();
  for (const auto& why : cell.reasons)
    reasons.push_back({{"stage", name_of(stage_of(why.reason))},
                       {"reason", name_of(why.reason)},
                       {"count", why.count},
                       {"details", why.details}});
  const auto success = expert_success(cell);
  return {{"candidates", cell.candidates}, {"accepted", cell.accepted}, {"grounded", success.grounded},
          {"shown", success.shown},        {"example", cell.example},   {"reasons", std::move(reasons)}};
}

Json json_of(const std::vector<CoverageRow>& rows, const TemplateCoverageOptions& options) {
  auto templates = Json::array();
  for (const auto& row : rows) {
    auto cells = Json::object();
    for (std::size_t i = 0; i < kSimulators.size(); ++i) {
      if (row.cells[i].claimed) cells[std::string(name_of(kSimulators[i]))] = json_of(row.cells[i]);
    }
    templates.push_back(
        {{"name", row.name}, {"class", name_of(row.split)}, {"predicates", row.predicates}, {"cells", cells}});
  }
  return {{"format", "unietp-coverage/1"},
          {"tries", options.tries},
          {"seed", options.seed},
          {"claimed", claimed_cells(rows).size()},
          {"empty", options.tries > 0 ? empty_cells(rows).size() : 0},
          {"templates", std::move(templates)}};
}

void print_rows(const std::vector<CoverageRow>& rows, const TemplateCoverageOptions& options,
                const std::vector<Mode>& modes) {
  std::printf("%-36s %-14s", "template", "class");
  for (const auto simulator : kSimulators) std::printf(" %-11s", std::string(name_of(simulator)).c_str());
  std::printf(" predicates\n");
  for (const auto& row : rows) {
    std::printf("%-36s %-14s", row.name.c_str(), std::string(name_of(row.split)).c_str());
    for (const auto& cell : row.cells) std::printf(" %-11s", to_text(cell).c_str());
    std::printf(" %s\n", join(row.predicates, " ").c_str());
  }
  const auto claimed = claimed_cells(rows).size(), empty = empty_cells(rows).size();
  if (options.tries == 0) {
    std::printf("%zu templates, %zu pairs of template and simulator; --tries 10 tries them\n", rows.size(), claimed);
    return;
  }
  for (const auto& [row, simulator] : empty_cells(rows)) {
    std::printf("\n%s on %s gave no task:\n", rows[row].name.c_str(),
                std::string(name_of(kSimulators[simulator])).c_str());
    for (const auto& why : rows[row].cells[simulator].reasons)
      std::printf("  %3d %s: %s\n", why.count, stage_and_name(why.reason).c_str(), why.example.c_str());
  }
  std::printf("\ncandidates with a start that the expert demonstrated:\n%s", expert_success_tables(rows).c_str());
  if (modes.size() > 1) std::printf("\n%s", to_text(mode_success(rows), modes).c_str());
  std::printf("%s%zu of %zu pairs of template and simulator have a verified task\n", empty == 0 ? "" : "\n",
              claimed - empty, claimed);
}

/// Positions of the templates asked for; all when none is named.
Result<std::vector<std::size_t>> positions_of(const std::vector<std::string>& names, const Resources& resources) {
  std::vector<std::string> known;
  for (const auto& source : resources.templates) known.push_back(source.name);
  for (const auto& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      return unknown_name_error("--template", name, known);
  }
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (names.empty() || std::find(names.begin(), names.end(), known[i]) != names.end()) positions.push_back(i);
  }
  return positions;
}

Exit coverage(const TemplateCoverageOptions& options, const CommandLine& program) {
  auto simulators = parse_simulators("--simulators", options.simulators);
  if (!simulators) return refuse(simulators.error());
  auto modes = parse_modes_to_make("--modes", options.modes);
  if (!modes) return refuse(modes.error());
  const auto reading = load_resources(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  const auto positions = positions_of(options.names, reading.resources);
  if (!positions) return refuse(positions.error());
  auto rows = coverage_of(reading.resources, *positions);
  for (auto& row : rows) {
    for (std::size_t i = 0; i < kSimulators.size(); ++i) {
      const bool asked = std::find(simulators->begin(), simulators->end(), kSimulators[i]) != simulators->end();
      row.cells[i].claimed = row.cells[i].claimed && asked;
    }
  }

  if (options.tries > 0) {
    RunConfiguration configuration;
    configuration.seed = options.seed;
    configuration.modes = *modes;
    configuration.simulators.assign(kSimulators.begin(), kSimulators.end());
    LayoutPool layouts(configuration, reading.resources, options.homes);
    const auto cells = claimed_cells(rows);
    const bool whole = for_each_home(
        cells.size(), options.threads, program,
        [&](std::size_t i) {
          const auto [row, simulator] = cells[i];
          auto trial = try_template(configuration, reading.resources, layouts, (*positions)[row],
                                    kSimulators[simulator], {options.tries, 0, program.interrupted});
          auto& cell = rows[row].cells[simulator];
          cell.candidates = trial.candidates;
          cell.accepted = static_cast<int>(trial.tasks.size());
          if (!trial.tasks.empty()) cell.example = trial.tasks.front().instruction.text;
          cell.reasons = std::move(trial.reasons);
          for (const Task& task : trial.tasks) {
            cell.steps[0] += static_cast<int>(task.demonstration.steps.size());
            for (const auto& other : task.in_other_modes)
              cell.steps[static_cast<std::size_t>(other.mode)] += static_cast<int>(other.steps.size());
          }
          return true;
        },
        "cells");
    if (!whole) return Exit::Interrupted;
  }

  if (options.json) {
    std::printf("%s\n", json_of(rows, options).dump(2).c_str());
  } else if (options.markdown) {
    std::printf("%s", coverage_page(rows, *modes, options.tries, options.seed).c_str());
  } else {
    print_rows(rows, options, *modes);
  }
  return options.tries > 0 && !empty_cells(rows).empty() ? Exit::Wrong : Exit::Ok;
}

}  // namespace

void add_template_coverage_command(CommandParser& group, CommandLine& program) {
  auto options = std::make_shared<TemplateCoverageOptions>();  // shared: the callback outlives this function
  options->simulators = join(simulator_names(), ",");
  auto* command = group.add_subcommand("coverage", "Show which templates give tasks on which simulators");
  command->explain(
      "Prints a table of templates, simulators and predicates. With --tries, candidates of each template "
      "go through all stages, and templates without a task are listed with the reasons. The same options "
      "give the same table for any number of threads. Exit code 1: a template gives no task on a simulator "
      "that it claims.",
      {{"unietp template coverage", "which templates claim which simulators"},
       {"unietp template coverage --tries 10", "7/10 means that 7 of 10 candidates became tasks"},
       {"unietp template coverage --tries 20 --template open-one,slice-one --simulators ai2thor", ""},
       {"unietp template coverage --tries 10 --modes M2",
        "also how many of the M1 demonstrations succeed in M2, and their lengths"},
       {"unietp template coverage --tries 10 --modes M1,M2,M3 --markdown > docs/coverage.md", ""}});
  command->add_option("--tries", options->tries, "Candidates of each template on each simulator (default: none)")
      ->within(0, limits::kAttempts);
  command->add_option("--template", options->names, "Templates by name (default: all)")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->one_each();
  add_simulators_option(*command, options->simulators, "Simulators (default: all)");
  command->add_option("--modes", options->modes, "Modes to demonstrate each candidate in (default: M1)")
      ->type_name("MODE,...")
      ->suggests({"M1", "M2", "M3"});
  command->add_option("--homes", options->homes, "Homes per simulator")->within(1, 100)->shows_default();
  command->add_option("--seed", options->seed, "Seed of homes and candidates")->shows_default();
  add_threads_option(*command, options->threads, program);
  command->add_flag("--json", options->json, "Print JSON, with all reasons");
  command->add_flag("--markdown", options->markdown, "Print Markdown");
  add_library_options(*command, program);
  command->callback([options, &program] { program.exit = coverage(*options, program); });
}

}  // namespace unietp
