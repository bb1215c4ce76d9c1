#include <algorithm>
#include <memory>

#include <nlohmann/json.hpp>

#include "akb/difference.h"
#include "akb/knowledge.h"
#include "akb/tables.h"
#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "core/text.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct KnowledgeDiffOptions {
  std::filesystem::path old, now;
  bool values = false, json = false;
};

/// All four simulators of a folder of tables or a compiled file.
std::vector<Knowledge> read_any(const std::filesystem::path& path, std::vector<Error>& errors) {
  std::vector<Knowledge> all;
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) {
    std::vector<Error> found;
    auto tables = read_all_tables(path, {}, found);
    errors.insert(errors.end(), found.begin(), found.end());
    for (std::size_t i = 0; found.empty() && i < tables.size(); ++i) {
      auto& t = tables[i];
      all.emplace_back(kSimulators[i], std::move(t.categories), std::move(t.affordances), std::move(t.placements),
                       std::move(t.effects), std::move(t.aliases), std::move(t.assets));
    }
    return all;
  }
  for (const auto simulator : kSimulators) {
    auto knowledge = load_knowledge(path, simulator);
    if (!knowledge) {
      errors.push_back(knowledge.error());
      return {};
    }
    all.push_back(std::move(*knowledge));
  }
  return all;
}

std::string line_of(std::string_view simulator, const Difference& d) {
  const std::string subject = std::string(simulator) + " " + d.category + " " + d.name + " ";
  if (!d.now) return "- " + subject + d.old->value + " " + source_text(d.old->source);
  if (!d.old) return "+ " + subject + d.now->value + " " + source_text(d.now->source);
  const std::string value = d.same_value() ? d.now->value : d.old->value + " -> " + d.now->value;
  const std::string from = source_text(d.old->source), to = source_text(d.now->source);
  return "~ " + subject + value + " " + (from == to ? to : from + " -> " + to);
}

Json side(const std::optional<Fact>& fact) {
  if (!fact) return nullptr;
  return {{"value", fact->value}, {"source", fact->source.source}, {"confidence", fact->source.confidence}};
}

Exit diff(const KnowledgeDiffOptions& options) {
  std::vector<Error> errors;
  const auto old = read_any(options.old, errors), now = read_any(options.now, errors);
  if (!errors.empty()) return refuse(errors);
  Json json = Json::array();
  std::size_t added = 0, removed = 0, changed = 0;
  for (std::size_t i = 0; i < kSimulators.size(); ++i) {
    const auto simulator = name_of(kSimulators[i]);
    for (const auto& d : differences(old[i], now[i])) {
      if (options.values && d.same_value()) continue;
      ++(d.old ? d.now ? changed : removed : added);
      if (options.json) {
        json.push_back({{"simulator", simulator},
                        {"category", d.category},
                        {"fact", d.name},
                        {"old", side(d.old)},
                        {"new", side(d.now)}});
      } else {
        print_line(line_of(simulator, d));
      }
    }
  }
  if (options.json) {
    print_line(Json{{"added", added}, {"removed", removed}, {"changed", changed}, {"facts", json}}.dump(2));
  } else {
    print_line(std::to_string(added) + " added, " + std::to_string(removed) + " removed, " + std::to_string(changed) +
               " changed");
  }
  return added + removed + changed == 0 ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_knowledge_diff_command(CommandParser& knowledge, CommandLine& program) {
  auto options = std::make_shared<KnowledgeDiffOptions>();  // shared: the callback outlives this function
  auto* command = knowledge.add_subcommand("diff", "Compare two knowledge bases, fact by fact");
  command->explain(
      "Each is a folder of tables or a compiled file of `unietp knowledge build`. Lines begin with + for added, - for "
      "removed and ~ for changed facts (the value, or only its source or confidence). Exit code 0 when both are equal, "
      "1 when they differ, 2 when one cannot be read.",
      {{"unietp knowledge diff old/data/akb data/akb", ""},
       {"unietp knowledge diff old.sqlite data/akb", ""},
       {"unietp knowledge diff old.sqlite data/akb --values",
        "only facts that are added, removed or have a new value"}});
  command->add_option("OLD", options->old, "Folder of tables or compiled file")->required();
  command->add_option("NEW", options->now, "Folder of tables or compiled file")->required();
  command->add_flag("--values", options->values, "Leave out facts where only the source or confidence changed");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &program] { program.exit = diff(*options); });
}

}  // namespace unietp
