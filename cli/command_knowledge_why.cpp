#include <memory>

#include <nlohmann/json.hpp>

#include "akb/override.h"
#include "akb/provenance.h"
#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "cli/common_options.h"
#include "core/files.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "sense/usual_places.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct KnowledgeWhyOptions {
  std::string simulator, category, fact;
  bool json = false;
};

struct OverrideInForce {
  std::string file;
  int line = 0;
  std::string value, reason;
};

/// All that can be said of one fact.
struct Explanation {
  std::string simulator, category, name;
  std::optional<Fact> fact;  // when it holds
  std::optional<License> license;
  std::optional<std::string> rule;  // the meaning of a derived one
  std::optional<Sense> sense;       // of a placement: whether things are usually there
  std::vector<OverrideInForce> overrides;
  std::vector<CuratedRow> curated;
  std::string override_file, override_row, curated_folder;  // where a person would change it
};

std::string example_value(const FactName& fact) {
  if (fact.detail == "capacity") return "4";
  if (fact.detail == "needs") return "closed|power_on";
  if (fact.word == "size" || fact.kind == FactName::Kind::Asset) return "0.3 x 0.2 x 0.1";
  if (fact.word == "slices") return "5 PIECES";
  if (fact.kind == FactName::Kind::Alias) return "synonym";
  return fact.kind == FactName::Kind::Property ? "VALUE" : "true";
}

std::vector<OverrideInForce> overrides_of(const DataFolders& folders, Simulator simulator, const std::string& category,
                                          const FactName& fact) {
  std::vector<OverrideInForce> found;
  for (const auto& file : override_files(folders.tables(), folders.overrides)) {
    const auto text = read_file(file);
    if (!text) continue;  // compiled a moment ago, so it is gone just now
    std::vector<Error> errors;
    for (const auto& row : read_overrides(file.string(), *text, errors)) {
      if (row.simulator == simulator && row.category == category && row.fact == fact)
        found.push_back({file.string(), row.fact_at.line, row.value, row.reason});
    }
  }
  return found;
}

/// A category named after a colon must be one of the simulator's.
std::vector<Error> unknown_object(const Knowledge& knowledge, const FactName& fact) {
  if (fact.kind != FactName::Kind::Placement && fact.kind != FactName::Kind::Effect) return {};
  const auto object = category_named(knowledge, fact.object);
  return object ? std::vector<Error>{} : std::vector<Error>{object.error()};
}

/// How usual a place is, whether a table has it or not.
std::optional<Sense> sense_of(const DataFolders& folders, const Knowledge& knowledge, const Category& category,
                              const FactName& fact, std::vector<Error>& errors) {
  const auto relation = placement_relation_named(fact.word);
  if (fact.kind != FactName::Kind::Placement || !relation || !fact.detail.empty()) return std::nullopt;
  const auto sense = read_common_sense(folders.root / "data/sense", errors);
  return grade_placement({category.name, *relation, fact.object, 0, 1, {}}, knowledge, sense);
}

Explanation explain(const DataFolders& folders, const Knowledge& knowledge, const Category& category,
                    const FactName& fact, std::vector<Error>& errors) {
  Explanation e;
  e.simulator = name_of(knowledge.simulator());
  e.category = category.name;
  e.name = to_text(fact);
  for (auto& known : facts_of(knowledge, category)) {
    if (known.name == e.name) e.fact = std::move(known);
  }
  if (e.fact) {
    e.license = license_of(read_licenses(folders.licenses(), errors), e.fact->source.source);
    if (e.fact->source.source.starts_with("derived:"))
      e.rule = meaning_of(read_rules(folders.tables() / "rules.csv", errors), e.fact->source.source);
  }
  e.sense = sense_of(folders, knowledge, category, fact, errors);
  e.overrides = overrides_of(folders, knowledge.simulator(), category.name, fact);
  e.curated = curated_rows(folders.tables() / "curated", knowledge.simulator(), category, fact);
  e.override_file = (folders.overrides.empty() ? folders.tables() / "override.csv" : folders.overrides.back()).string();
  e.override_row =
      e.simulator + "," + e.category + "," + e.name + "," + (e.fact ? "VALUE" : example_value(fact)) + ",REASON";
  e.curated_folder = (folders.tables() / "curated" / e.simulator).string();
  return e;
}

void print(const Explanation& e, const DataFolders& folders) {
  const std::string subject = e.simulator + " " + e.category + " " + e.name;
  if (e.fact) {
    print_line(subject + ": " + e.fact->value);
    print_line("  source     " + e.fact->source.source + ", confidence " + number_text(e.fact->source.confidence));
    print_line("  origin     " +
               (e.license ? e.license->origin : "not among the allowed ones of " + folders.licenses().string()));
    if (e.license) print_line("  licence    " + e.license->license);
    if (e.rule) print_line("  rule       " + *e.rule);
  } else {
    print_line(subject + ": does not hold; no table says it");
  }
  if (e.sense) {
    print_line("  sense      " + std::string(name_of(e.sense->grade)));
    for (const auto& reason : e.sense->reasons) print_line("               " + reason);
  }
  for (const auto& row : e.overrides)
    print_line("  override   " + row.file + ":" + std::to_string(row.line) + " says " +
               (row.value.empty() ? "nothing" : row.value) + ": " + row.reason);
  if (e.fact && e.overrides.empty() && e.fact->source.source.starts_with("override:"))
    print_line("  override   of another cell: the row of a category has one source but for size, mass and synset");
  for (const auto& row : e.curated)
    print_line("  by hand    " + (folders.tables() / "curated" / row.file).string() + ":" + std::to_string(row.line));
  print_line(std::string(e.fact ? "  change it  " : "  make it so ") + "with a row in " + e.override_file + ":");
  print_line("               " + e.override_row);
  print_line("             or by hand in " + e.curated_folder + "/, then `unietp knowledge import`");
}

Json json_of(const Explanation& e) {
  Json json{{"simulator", e.simulator}, {"category", e.category}, {"fact", e.name}, {"holds", e.fact.has_value()}};
  if (e.fact) {
    json["value"] = e.fact->value;
    json["source"] = e.fact->source.source;
    json["confidence"] = e.fact->source.confidence;
  }
  if (e.license) {
    json["origin"] = e.license->origin;
    json["licence"] = e.license->license;
  }
  if (e.rule) json["rule"] = *e.rule;
  if (e.sense) json["sense"] = {{"grade", name_of(e.sense->grade)}, {"reasons", e.sense->reasons}};
  json["overrides"] = Json::array();
  for (const auto& row : e.overrides)
    json["overrides"].push_back({{"file", row.file}, {"line", row.line}, {"value", row.value}, {"reason", row.reason}});
  json["curated"] = Json::array();
  for (const auto& row : e.curated) json["curated"].push_back({{"file", row.file}, {"line", row.line}});
  json["change"] = {{"file", e.override_file}, {"row", e.override_row}, {"curated", e.curated_folder}};
  return json;
}

Exit why(const KnowledgeWhyOptions& options, const CommandLine& program) {
  const auto simulators = parse_simulators("simulator", options.simulator);
  if (!simulators) return refuse(simulators.error());
  if (simulators->size() != 1)
    return refuse(Error{Error::Kind::Usage, "simulator", {}, "several simulators; expected one"});
  const auto fact = parse_fact(options.fact);
  if (!fact) return refuse(fact.error());
  std::vector<Error> errors;
  const auto loaded = load_some(program, *simulators, errors);
  if (!errors.empty()) return refuse(errors);
  const Knowledge& knowledge = loaded.front();
  const auto category = category_named(knowledge, options.category);
  if (!category) return refuse(category.error());
  errors = unknown_object(knowledge, *fact);
  if (!errors.empty()) return refuse(errors);
  const auto explanation = explain(program.folders, knowledge, **category, *fact, errors);
  if (!errors.empty()) return refuse(errors);
  if (options.json) {
    print_line(json_of(explanation).dump(2));
  } else {
    print(explanation, program.folders);
  }
  return explanation.fact ? Exit::Ok : Exit::Wrong;
}

}  // namespace

void add_knowledge_why_command(CommandParser& knowledge, CommandLine& program) {
  auto options = std::make_shared<KnowledgeWhyOptions>();  // shared: the callback outlives this function
  auto* command = knowledge.add_subcommand("why", "Explain one fact: its source, its license, and how to change it");
  command->explain(
      "A fact is one of:\n"
      "  a property       size, mass, synset, display, plural, countable, movable,\n"
      "                   archetype, rooms, colours or materials\n"
      "  an affordance    openable\n"
      "  a place          on:CounterTop or on:CounterTop:capacity; also inside:,\n"
      "                   next_to: and under:\n"
      "  an effect        heats:Potato or heats:Potato:needs\n"
      "  another name     alias:cup\n"
      "  a 3D model       asset:Mug_1\n\n"
      "Exit code 0 when the fact holds, 1 when it does not, 2 when a name is unknown.",
      {{"unietp knowledge why ai2thor Mug size", ""},
       {"unietp knowledge why ai2thor Fridge openable", ""},
       {"unietp knowledge why ai2thor Mug on:CounterTop", ""},
       {"unietp knowledge why ai2thor Microwave heats:Potato", ""},
       {"unietp knowledge why ai2thor Mug alias:cup", ""}});
  add_simulator_argument(*command, options->simulator, "The simulator")->required();
  command->add_option("CATEGORY", options->category, "A category by the simulator's name for it")->required();
  command->add_option("FACT", options->fact, "The fact, as listed above")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &program] { program.exit = why(*options, program); });
}

}  // namespace unietp
