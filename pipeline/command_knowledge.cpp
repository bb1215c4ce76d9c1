#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>

#include "akb/importers.h"
#include "core/text.h"
#include "pipeline/commands.h"
#include "pipeline/configuration.h"

namespace unietp {
namespace {

constexpr const char* kHelp =
    "What the tables in data/akb/ say of each simulator's categories.\n"
    "\n"
    "  unietp knowledge stats                    how much is known\n"
    "  unietp knowledge show ai2thor             all categories\n"
    "  unietp knowledge show ai2thor Mug         one category, each fact with its source\n"
    "  unietp knowledge build                    check and compile the tables\n"
    "  unietp knowledge import ../upstream       write the tables anew from the simulators' metadata\n"
    "  unietp knowledge complete ...             ask a language model for what they lack";

struct Options {
  std::string simulator, category;
  std::filesystem::path upstream;
};

std::string told(const Source& source) {
  return "[" + source.source + ", confidence " + number_text(source.confidence) + "]";
}

void line(const std::string& text) { std::printf("%s\n", text.c_str()); }

Exit build(const CommandLine& program) {
  const auto compiled = compiled_knowledge(program.folders);
  if (!compiled.errors.empty()) return refuse(compiled.errors);
  line(compiled.database.string());
  return Exit::Ok;
}

Exit stats(const CommandLine& program) {
  const auto reading = load_backends(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  std::printf("%-12s %10s %11s %10s %7s %7s\n", "simulator", "categories", "affordances", "placements", "effects",
              "aliases");
  for (const auto& backend : reading.backends) {
    const auto& knowledge = backend.knowledge;
    std::printf("%-12s %10zu %11zu %10zu %7zu %7zu\n", std::string(name_of(knowledge.simulator())).c_str(),
                knowledge.categories().size(), knowledge.affordances().size(), knowledge.placements().size(),
                knowledge.effects().size(), knowledge.aliases().size());
  }
  return Exit::Ok;
}

void show_category(const Knowledge& knowledge, const Category& category) {
  line(category.name + ": " + category.display + ", plural " + category.plural +
       (category.synset.empty() ? "" : ", " + category.synset) + " " + told(category.source));
  line(std::string("  ") + (category.movable ? "movable" : "furniture") + ", built as " +
       std::string(name_of(category.archetype)));
  line("  size " + number_text(category.size.x()) + " x " + number_text(category.size.y()) + " x " +
       number_text(category.size.z()) + " m " + told(category.size_source));
  line("  mass " + number_text(category.mass) + " kg " + told(category.mass_source));
  line("  rooms " + join(category.rooms, ", "));
  for (const auto& fact : knowledge.affordances()) {
    if (fact.category == category.name) line("  is " + fact.affordance + " " + told(fact.source));
  }
  for (const auto& placement : knowledge.placements()) {
    if (placement.object == category.name || placement.receptacle == category.name)
      line("  " + placement.object + " " + placement.relation + " " + placement.receptacle + ", likely " +
           number_text(placement.likelihood) + ", at most " + std::to_string(placement.capacity) + " " +
           told(placement.source));
  }
  for (const auto& effect : knowledge.effects()) {
    if (effect.tool != category.name && effect.target != category.name) continue;
    line("  " + effect.tool + " " + effect.effect + " " + effect.target +
         (effect.gives.empty() ? "" : " giving " + effect.gives) +
         (effect.needs.empty() ? "" : ", needs " + join(effect.needs, ", ")) + " " + told(effect.source));
  }
  for (const auto& alias : knowledge.aliases()) {
    if (alias.category == category.name) line("  " + alias.kind + ": " + alias.text + " " + told(alias.source));
  }
}

Exit show(const Options& options, const CommandLine& program) {
  const auto simulators = parse_simulators("simulator", options.simulator);
  if (!simulators) return refuse(simulators.error());
  const auto reading = load_backends(program.folders);
  if (!reading.errors.empty()) return refuse(reading.errors);
  for (const auto simulator : *simulators) {
    const auto& knowledge = reading.backends[static_cast<std::size_t>(simulator)].knowledge;
    if (options.category.empty()) {
      for (const auto& category : knowledge.categories())
        std::printf("%-28s %-10s %s\n", category.name.c_str(), category.movable ? "movable" : "furniture",
                    join(knowledge.affordances_of(category.name), " ").c_str());
      continue;
    }
    const Category* category = knowledge.find(options.category);
    if (category != nullptr) {
      show_category(knowledge, *category);
      continue;
    }
    std::vector<std::string> names;
    for (const auto& known : knowledge.categories()) names.push_back(known.name);
    const auto near = nearest_name(options.category, names);
    return refuse({Error::Kind::Usage,
                   std::string(name_of(simulator)),
                   {},
                   "has no category \"" + options.category + "\"" +
                       (near.empty() ? "" : ", did you mean \"" + near + "\"") + "; `unietp knowledge show " +
                       std::string(name_of(simulator)) + "` lists all"});
  }
  return Exit::Ok;
}

Exit import(const Options& options, const CommandLine& program) {
  const auto done = import_all(options.upstream, program.folders.tables());
  if (!done) return refuse(done.error());
  return stats(program);
}

}  // namespace

void add_knowledge_command(CLI::App& app, CommandLine& program) {
  auto options = std::make_shared<Options>();  // shared: the callbacks below outlive this function
  auto* command = app.add_subcommand("knowledge", kHelp);
  command->require_subcommand(1);
  command->add_subcommand("build", "Check and compile the tables; tells where the database is")->callback([&program] {
    program.exit = build(program);
  });
  command->add_subcommand("stats", "Count what is known of each simulator")->callback([&program] {
    program.exit = stats(program);
  });
  auto* shown = command->add_subcommand("show", "Categories of a simulator, or all facts of one with their sources");
  shown->add_option("simulator", options->simulator, "ai2thor, virtualhome, habitat or behavior")->required();
  shown->add_option("category", options->category, "The simulator's own name of it");
  shown->callback([options, &program] { program.exit = show(*options, program); });
  auto* imported = command->add_subcommand("import", "Write data/akb/ anew from the simulators' metadata");
  imported->add_option("folder", options->upstream, "Folder with ai2thor/, virtualhome/, habitat/, behavior/")
      ->required();
  imported->callback([options, &program] { program.exit = import(*options, program); });
  add_knowledge_complete_command(*command, program);
}

}  // namespace unietp
