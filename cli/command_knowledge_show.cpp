#include <cstdio>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "cli/command_knowledge.h"
#include "cli/command_parser.h"
#include "cli/common_options.h"
#include "cli/sense_folder.h"
#include "core/text.h"
#include "dataset/configuration.h"
#include "sense/usual_places.h"

namespace unietp {
namespace {

using Json = nlohmann::ordered_json;

struct KnowledgeShowOptions {
  std::string simulator, category;
  bool json = false;
};

void show_all(const Knowledge& knowledge) {
  for (const auto& category : knowledge.categories())
    std::printf("%-28s %-10s %s\n", category.name.c_str(), category.movable ? "movable" : "furniture",
                join(knowledge.affordances_of(category.name), " ").c_str());
}

Json all_json(const Knowledge& knowledge) {
  Json all = Json::array();
  for (const auto& category : knowledge.categories())
    all.push_back({{"category", category.name},
                   {"movable", category.movable},
                   {"affordances", knowledge.affordances_of(category.name)}});
  return all;
}

void show_rows(const Knowledge& knowledge, const Category& category, const CommonSense& sense) {
  for (const auto& placement : knowledge.placements()) {
    if (placement.object == category.name || placement.receptacle == category.name)
      print_line("  " + placement.object + " " + std::string(info(placement.relation).name) + " " +
                 placement.receptacle + ", likely " + number_text(placement.likelihood) + ", at most " +
                 std::to_string(placement.capacity) + ", " +
                 std::string(name_of(grade_placement(placement, knowledge, sense).grade)) + " " +
                 source_text(placement.source));
  }
  for (const auto& effect : knowledge.effects()) {
    if (effect.tool != category.name && effect.target != category.name) continue;
    print_line("  " + effect.tool + " " + std::string(name_of(effect.treatment)) + " " + effect.target +
               (effect.gives.empty() ? "" : " giving " + effect.gives) +
               (effect.needs.empty() ? "" : ", needs " + join(names_of(effect.needs), ", ")) + " " +
               source_text(effect.source));
  }
  for (const auto& alias : knowledge.aliases()) {
    if (alias.category == category.name)
      print_line("  " + std::string(name_of(alias.kind)) + ": " + alias.text + " " + source_text(alias.source));
  }
  for (const Asset* asset : knowledge.asset_rows_of(category.name))
    print_line("  model " + asset->name + ", " + size_text(asset->size) + " m " + source_text(asset->source));
}

void show_category(const Knowledge& knowledge, const Category& category, const CommonSense& sense) {
  print_line(category.name + ": " + category.display + ", plural " + category.plural +
             (category.synset.empty() ? "" : ", " + category.synset) + " " + source_text(category.source));
  print_line(std::string("  ") + (category.movable ? "movable" : "furniture") + ", built as " +
             std::string(name_of(category.archetype)));
  if (!category.synset.empty() && category.synset_source != category.source)
    print_line("  synset " + category.synset + " " + source_text(category.synset_source));
  print_line("  size " + size_text(category.size) + " m " + source_text(category.size_source));
  print_line("  mass " + number_text(category.mass) + " kg " + source_text(category.mass_source));
  print_line("  rooms " + join(category.rooms, ", "));
  for (const auto* fact : knowledge.affordance_facts_of(category.name))
    print_line("  is " + fact->affordance + " " + source_text(fact->source));
  if (const auto* kind = sense.kind_of(knowledge.simulator(), category.name))
    print_line("  of the kind " + kind->kind + " [" + kind->source + "]");
  show_rows(knowledge, category, sense);
}

Json category_json(const Knowledge& knowledge, const Category& category, const CommonSense& sense) {
  std::map<std::string, Grade> grades;  // by the name of a place
  for (const auto& placement : knowledge.placements()) {
    if (placement.object == category.name)
      grades.emplace(std::string(info(placement.relation).name) + ":" + placement.receptacle,
                     grade_placement(placement, knowledge, sense).grade);
  }
  Json facts = Json::array();
  for (const auto& fact : facts_of(knowledge, category)) {
    facts.push_back(json_of(fact));
    if (const auto grade = grades.find(fact.name); grade != grades.end())
      facts.back()["sense"] = name_of(grade->second);
  }
  return {{"simulator", name_of(knowledge.simulator())}, {"category", category.name}, {"facts", std::move(facts)}};
}

Exit show(const KnowledgeShowOptions& options, const CommandLine& program) {
  const auto simulators = parse_simulators("simulator", options.simulator);
  if (!simulators) return refuse(simulators.error());
  std::vector<Error> errors;
  const auto all = load_some(program, *simulators, errors);
  const auto sense = read_common_sense(sense_folder(program), errors);
  if (!errors.empty()) return refuse(errors);
  Json json = Json::array();
  for (const auto& knowledge : all) {
    if (options.category.empty()) {
      if (options.json) {
        json.push_back({{"simulator", name_of(knowledge.simulator())}, {"categories", all_json(knowledge)}});
      } else {
        show_all(knowledge);
      }
      continue;
    }
    const auto category = category_named(knowledge, options.category);
    if (!category) return refuse(category.error());
    if (options.json) {
      json.push_back(category_json(knowledge, **category, sense));
    } else {
      show_category(knowledge, **category, sense);
    }
  }
  if (options.json) print_line((json.size() == 1 ? json.front() : json).dump(2));
  return Exit::Ok;
}

}  // namespace

void add_knowledge_show_command(CommandParser& knowledge, CommandLine& program) {
  auto options = std::make_shared<KnowledgeShowOptions>();  // shared: the callback outlives this function
  auto* command = knowledge.add_subcommand("show", "Print the categories of a simulator, or all facts of one");
  command->explain("", {{"unietp knowledge show ai2thor", "one line per category: its name and affordances"},
                        {"unietp knowledge show ai2thor Mug",
                         "every fact with its source, including facts of other categories that name it"},
                        {"unietp knowledge show ai2thor Mug --json", "the facts of the category itself"}});
  add_simulator_argument(*command, options->simulator, "The simulator")->required();
  command->add_option("CATEGORY", options->category, "A category by the simulator's name for it");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &program] { program.exit = show(*options, program); });
}

}  // namespace unietp
