#include "cli/command_knowledge.h"

#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "akb/importers.h"
#include "cli/command_parser.h"
#include "cli/sense_folder.h"
#include "core/text.h"
#include "sense/usual_places.h"

namespace unietp {
namespace {

Exit build(const std::filesystem::path& out, const CommandLine& program) {
  const auto compiled =
      out.empty() ? compiled_knowledge(program.folders) : compile_knowledge_into(out, program.folders);
  if (!compiled.errors.empty()) return refuse(compiled.errors);
  print_line(compiled.database.string());
  return Exit::Ok;
}

Exit import(const std::filesystem::path& upstream, const CommandLine& program) {
  std::vector<Error> errors;
  const auto sense = read_common_sense(sense_folder(program), errors);
  if (!errors.empty()) return refuse(errors);
  const auto absurd = [&](Simulator simulator) -> AbsurdPlace {
    return [&sense, simulator](const Category& object, Predicate relation, const Category& receptacle) {
      return is_absurd(sense, simulator, object, relation, receptacle);
    };
  };
  const auto done = import_all(upstream, program.folders.tables(), absurd);
  if (!done) return refuse(done.error());
  return print_sizes(program);
}

}  // namespace

std::vector<Knowledge> load_some(const CommandLine& program, const std::vector<Simulator>& simulators,
                                 std::vector<Error>& errors) {
  const auto compiled = compiled_knowledge(program.folders);
  errors.insert(errors.end(), compiled.errors.begin(), compiled.errors.end());
  std::vector<Knowledge> all;
  for (const auto simulator : simulators) {
    if (!errors.empty()) break;
    auto knowledge = load_knowledge(compiled.database, simulator);
    if (!knowledge) {
      errors.push_back(knowledge.error());
    } else {
      all.push_back(std::move(*knowledge));
    }
  }
  return all;
}

Result<const Category*> category_named(const Knowledge& knowledge, std::string_view name) {
  if (const Category* category = knowledge.find(name)) return category;
  std::vector<std::string> names;
  for (const auto& known : knowledge.categories()) names.push_back(known.name);
  const auto near = nearest_name(name, names);
  const std::string simulator(name_of(knowledge.simulator()));
  return Error{Error::Kind::Usage,
               simulator,
               {},
               "has no category \"" + std::string(name) + "\"" +
                   (near.empty() ? "" : ", did you mean \"" + near + "\"") + "; `unietp knowledge show " + simulator +
                   "` lists them"};
}

void print_line(const std::string& text) { std::printf("%s\n", text.c_str()); }

std::string source_text(const Source& source) {
  return "[" + source.source + ", confidence " + number_text(source.confidence) + "]";
}

nlohmann::ordered_json json_of(const Fact& fact) {
  return {{"fact", fact.name},
          {"value", fact.value},
          {"source", fact.source.source},
          {"confidence", fact.source.confidence}};
}

void add_knowledge_command(CommandParser& app, CommandLine& program) {
  auto* group = app.add_subcommand("knowledge", "Inspect and extend what is known about objects");
  group->explain(
      "Facts about each simulator's object categories: sizes, affordances, places, effects and names. They "
      "are tables in data/akb/. To change a fact without touching the tables, give --overrides FILE.",
      {{"unietp knowledge show ai2thor Mug", ""},
       {"unietp knowledge why ai2thor Mug size", ""},
       {"unietp knowledge stats", ""}});
  group->require_subcommand();
  add_knowledge_show_command(*group, program);
  add_knowledge_why_command(*group, program);
  add_knowledge_stats_command(*group, program);
  add_knowledge_diff_command(*group, program);
  auto path = std::make_shared<std::filesystem::path>();  // shared: the callbacks outlive this function
  auto* built = group->add_subcommand("build", "Check the tables, compile them and print where the database is");
  built->explain(
      "Other commands compile the tables when they need to, so this is only useful to check them or to "
      "ship the database.",
      {{"unietp knowledge build", ""}, {"unietp knowledge build --out out/compiled", ""}});
  built->add_option("--out", *path, "Folder for the database (default: the user's cache)")->folder()->output();
  built->callback([path, &program] { program.exit = build(*path, program); });
  auto* imported = group->add_subcommand("import", "Rewrite data/akb/ from the simulators' metadata");
  imported->explain("docs/knowledge.md lists the metadata files.", {{"unietp knowledge import metadata", ""}});
  imported->add_option("FOLDER", *path, "Folder with ai2thor/, virtualhome/, habitat/ and behavior/")
      ->required()
      ->folder();
  imported->callback([path, &program] { program.exit = import(*path, program); });
  add_knowledge_complete_command(*group, program);
  add_sense_fit_command(*group, program);
  add_sense_measure_command(*group, program);
}

}  // namespace unietp
