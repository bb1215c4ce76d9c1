#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "akb/coverage.h"
#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "cli/common_options.h"
#include "core/text.h"
#include "dataset/configuration.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct KnowledgeStatsOptions {
  std::string simulator;
  bool missing = false, json = false;
};

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// "metadata 80 %, derived 20 %"
std::string kinds_text(const FactCounts& counted) {
  std::vector<std::string> parts;
  for (const auto& [kind, facts] : counted.by_kind) {
    char text[64];
    (void)std::snprintf(text, sizeof text, "%s %.0f %%", kind.c_str(), 100 * share(facts, counted.facts));
    parts.emplace_back(text);
  }
  return join(parts, ", ");
}

void print_coverage(std::string_view simulator, const Coverage& coverage) {
  std::printf("%s: %zu categories\n\n", std::string(simulator).c_str(), coverage.categories);
  std::printf("  %-12s %10s %7s  %s\n", "affordance", "categories", "share", "from");
  for (const auto& [name, counted] : coverage.affordances)
    std::printf("  %-12s %10zu %5.0f %%  %s\n", name.c_str(), counted.facts,
                100 * share(counted.facts, coverage.categories), kinds_text(counted).c_str());
  std::printf("\n  %-12s %10s %10s  %s\n", "table", "facts", "confidence", "from");
  for (const auto& [name, counted] : coverage.tables)
    std::printf("  %-12s %10zu %10.2f  %s\n", name.c_str(), counted.facts, counted.mean_confidence(),
                kinds_text(counted).c_str());
  std::printf("\n  %-48s", "source");
  for (const auto& [name, counted] : coverage.tables) std::printf(" %10s", name.c_str());
  std::printf("\n");
  std::map<std::string, bool> sources;
  for (const auto& [name, counted] : coverage.tables) {
    for (const auto& [source, facts] : counted.by_source) sources[source] = true;
  }
  for (const auto& [source, used] : sources) {
    std::printf("  %-48s", source.c_str());
    for (const auto& [name, counted] : coverage.tables) {
      const auto at = counted.by_source.find(source);
      std::printf(" %10s", at == counted.by_source.end() ? "" : std::to_string(at->second).c_str());
    }
    std::printf("\n");
  }
  std::printf("\n");
  for (const auto& [what, names] : coverage.missing)
    std::printf("  %zu categories without %s\n", names.size(), what.c_str());
  std::printf("\n");
}

Json counted_json(const FactCounts& counted) {
  return {{"facts", counted.facts},
          {"confidence", counted.mean_confidence()},
          {"by_kind", counted.by_kind},
          {"by_source", counted.by_source}};
}

Json coverage_json(std::string_view simulator, const Coverage& coverage) {
  Json affordances = Json::object(), tables = Json::object(), missing = Json::object();
  for (const auto& [name, counted] : coverage.affordances) {
    affordances[name] = counted_json(counted);
    affordances[name]["share"] = share(counted.facts, coverage.categories);
  }
  for (const auto& [name, counted] : coverage.tables) tables[name] = counted_json(counted);
  for (const auto& [what, names] : coverage.missing) missing[what] = names;
  return {{"simulator", simulator},
          {"categories", coverage.categories},
          {"affordances", std::move(affordances)},
          {"tables", std::move(tables)},
          {"missing", std::move(missing)}};
}

Exit stats(const KnowledgeStatsOptions& options, const CommandLine& program) {
  const bool all = options.simulator.empty();
  if (all && !options.missing && !options.json) return print_sizes(program);
  const Result<std::vector<Simulator>> simulators = all ? std::vector<Simulator>(kSimulators.begin(), kSimulators.end())
                                                        : parse_simulators("simulator", options.simulator);
  if (!simulators) return refuse(simulators.error());
  std::vector<Error> errors;
  const auto known = load_some(program, *simulators, errors);
  if (!errors.empty()) return refuse(errors);
  Json json = Json::array();
  for (const auto& knowledge : known) {
    const auto coverage = coverage_of(knowledge);
    const auto simulator = name_of(knowledge.simulator());
    if (options.json) {
      json.push_back(coverage_json(simulator, coverage));
    } else if (options.missing) {
      for (const auto& [what, names] : coverage.missing) {
        for (const auto& name : names) print_line(join({std::string(simulator), name, "has no", what}, " "));
      }
    } else {
      print_coverage(simulator, coverage);
    }
  }
  if (options.json) print_line(json.dump(2));
  return Exit::Ok;
}

}  // namespace

Exit print_sizes(const CommandLine& program) {
  std::vector<Error> errors;
  const auto all = load_some(program, {kSimulators.begin(), kSimulators.end()}, errors);
  if (!errors.empty()) return refuse(errors);
  std::printf("%-12s %10s %11s %10s %7s %7s %6s\n", "simulator", "categories", "affordances", "placements", "effects",
              "aliases", "assets");
  for (const auto& knowledge : all)
    std::printf("%-12s %10zu %11zu %10zu %7zu %7zu %6zu\n", std::string(name_of(knowledge.simulator())).c_str(),
                knowledge.categories().size(), knowledge.affordances().size(), knowledge.placements().size(),
                knowledge.effects().size(), knowledge.aliases().size(), knowledge.assets().size());
  return Exit::Ok;
}

void add_knowledge_stats_command(CommandParser& knowledge, CommandLine& program) {
  auto options = std::make_shared<KnowledgeStatsOptions>();  // shared: the callback outlives this function
  auto* command = knowledge.add_subcommand("stats", "Count the facts of each simulator by table and source");
  command->explain("", {{"unietp knowledge stats", "the size of each table of each simulator"},
                        {"unietp knowledge stats behavior",
                         "by affordance, table and source, and how many categories lack something"},
                        {"unietp knowledge stats behavior --missing", "the categories that lack something"},
                        {"unietp knowledge stats --json", "all of it"}});
  add_simulator_argument(*command, options->simulator, "The simulator (default: table sizes of all)");
  command->add_flag("--missing", options->missing, "List categories without a synset, rooms, places or aliases");
  command->add_flag("--json", options->json, "Print JSON, with the names of incomplete categories");
  command->callback([options, &program] { program.exit = stats(*options, program); });
}

}  // namespace unietp
